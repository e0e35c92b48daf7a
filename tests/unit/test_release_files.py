"""Files for distributing the project agree with what they describe."""

import os
import re
import subprocess
from pathlib import Path
from typing import Dict, List, Set

import pytest
import yaml

REPOSITORY = Path(os.path.realpath(__file__)).parents[2]
MANIFESTS = sorted(
    path for folder in ("src", "underlay", "tests") for path in REPOSITORY.glob(f"{folder}/**/package.xml")
)
OURS = {path.parent.name for path in MANIFESTS} | {"roboframenet_tests"}
#: Keys whose Debian package has another name than the key suggests.
OTHER_NAMES: Dict[str, str] = {"message_generation": "ros-message-generation"}


def debian_packages() -> Set[str]:
    texts = [path.read_text(encoding="utf-8") for path in (REPOSITORY / "scripts").glob("apt-packages*.txt")]
    return {word for word in re.sub(r"#.*", "", "\n".join(texts)).split() if not word.startswith("@")}


def own_keys() -> Set[str]:
    text = (REPOSITORY / "rosdep" / "roboframenet.yaml").read_text(encoding="utf-8")
    return set(yaml.safe_load(text))


@pytest.mark.parametrize("manifest", MANIFESTS, ids=lambda path: path.parent.name)
def test_every_dependency_is_installed_by_setup(manifest: Path) -> None:
    text = manifest.read_text(encoding="utf-8")
    keys = set(re.findall(r"<\w*depend[^>]*>([\w-]+)<", text)) - OURS - own_keys()
    installed = debian_packages()
    dashed = {key: key.replace("_", "-") for key in keys}
    missing = {
        key
        for key, name in dashed.items()
        if not {key, name, f"python3-{name}", f"ros-{name}", f"lib{name}-dev", OTHER_NAMES.get(key, "")} & installed
    }
    assert not missing


def wanted_packages(tmp_path: Path, release: str) -> List[str]:
    """Return what scripts/setup installs on a release: its function, with another /etc/os-release."""
    (tmp_path / "os-release").write_text(f"VERSION_CODENAME={release}\n", encoding="utf-8")
    setup = (REPOSITORY / "scripts" / "setup").read_text(encoding="utf-8")
    function = re.search(r"^wanted_packages\(\) \{.*?^\}", setup, re.MULTILINE | re.DOTALL)
    assert function
    code = function.group().replace("/etc/os-release", str(tmp_path / "os-release"))
    command = f"{code}\nwanted_packages {REPOSITORY}/scripts/apt-packages.txt"
    ended = subprocess.run(["bash", "-c", command], capture_output=True, text=True, timeout=60, check=True)
    return ended.stdout.split()


def test_a_release_gets_the_packages_that_it_has(tmp_path: Path) -> None:
    bookworm, trixie = wanted_packages(tmp_path, "bookworm"), wanted_packages(tmp_path, "trixie")
    assert set(bookworm) - set(trixie) == {"python3-pocketsphinx"} and set(trixie) < set(bookworm)
    assert {"python3-rospy", "catkin", "catkin-lint"} <= set(trixie)
    # What apt does not have comes from pip.
    assert "pocketsphinx==" in (REPOSITORY / "requirements.txt").read_text(encoding="utf-8")


def test_keys_of_our_own_are_used() -> None:
    texts = "".join(path.read_text(encoding="utf-8") for path in MANIFESTS)
    assert {key for key in own_keys() if f">{key}<" not in texts} == set()


def test_what_continuous_integration_runs_exists() -> None:
    text = (REPOSITORY / ".github" / "workflows" / "test.yml").read_text(encoding="utf-8")
    commands = [step["run"] for job in yaml.safe_load(text)["jobs"].values() for step in job["steps"] if "run" in step]
    makefile = (REPOSITORY / "Makefile").read_text(encoding="utf-8")
    own = [command for command in commands if not command.startswith("apt-get")]
    assert own
    for command in own:
        program, _, target = command.partition(" ")
        assert (REPOSITORY / program).exists() or (program == "make" and f"\n{target}:" in makefile)


def test_templates_of_issues_have_a_name() -> None:
    for path in REPOSITORY.glob(".github/ISSUE_TEMPLATE/*.md"):
        _, head, body = path.read_text(encoding="utf-8").split("---\n", 2)
        assert {"name", "about"} <= set(yaml.safe_load(head)) and body.strip()


def test_docker_copies_what_it_runs() -> None:
    lines = (REPOSITORY / "Dockerfile").read_text(encoding="utf-8").splitlines()
    before = [line.split()[1:-1] for line in lines[: lines.index("RUN make setup")] if line.startswith("COPY")]
    patterns = [pattern for names in before for pattern in names]
    assert all(list(REPOSITORY.glob(pattern)) for pattern in patterns)
    assert {"Makefile", "scripts"} <= set(patterns)
