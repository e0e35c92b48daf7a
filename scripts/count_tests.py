"""Count the test cases in a folder of JUnit files and print one closing line."""

import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path


def main() -> int:
    """Print each failure, why tests were skipped, and 'N passed, N failed'; return 1 when one failed or none ran."""
    passed = 0
    failures = []
    skipped = []
    for path in sorted(Path(sys.argv[1]).rglob("*.xml")):
        cases = ElementTree.parse(path).getroot().findall(".//testcase")
        failed = [case for case in cases if case.find("failure") is not None or case.find("error") is not None]
        # Beside the file with the cases, rostest writes a wrapper; it counts only if it reports a failure.
        if path.name.startswith("rostest-") and not failed:
            continue
        reasons = [case.find("skipped").get("message", "") for case in cases if case.find("skipped") is not None]
        passed += len(cases) - len(failed) - len(reasons)
        skipped += [f"{path.parent.name}: {reason}" for reason in reasons]
        failures += [f"{path.parent.name}: {case.get('classname')}.{case.get('name')}" for case in failed]
    for failure in failures:
        print(f"FAILED {failure}")
    for reason in sorted(set(skipped)):
        print(f"SKIPPED {skipped.count(reason)} of {reason}")
    print(f"{passed} passed, {len(failures)} failed" + (f", {len(skipped)} skipped" if skipped else ""))
    return 1 if failures or not (passed or skipped) else 0


if __name__ == "__main__":
    sys.exit(main())
