"""Count the test cases in a folder of JUnit files and print one closing line."""
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path


def main() -> int:
    """Print 'N passed, N failed' and each failure's name; return 1 when one failed or none ran."""
    passed = 0
    failures = []
    skipped = 0
    for path in sorted(Path(sys.argv[1]).rglob("*.xml")):
        cases = ElementTree.parse(path).getroot().findall(".//testcase")
        failed = [case for case in cases if case.find("failure") is not None or case.find("error") is not None]
        # rostest writes a wrapper beside the file with the cases: it counts only when it tells of a failure.
        if path.name.startswith("rostest-") and not failed:
            continue
        skipped_here = sum(case.find("skipped") is not None for case in cases)
        passed += len(cases) - len(failed) - skipped_here
        skipped += skipped_here
        failures += [f"{path.parent.name}: {case.get('classname')}.{case.get('name')}" for case in failed]
    for failure in failures:
        print(f"FAILED {failure}")
    print(f"{passed} passed, {len(failures)} failed" + (f", {skipped} skipped" if skipped else ""))
    return 1 if failures or passed == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
