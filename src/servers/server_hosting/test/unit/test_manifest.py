"""Manifest files and what is wrong with them."""

import xml.etree.ElementTree

import pytest

from checked_files.problem import FileRefused
from server_hosting.manifest import by_frame, load_manifests
from server_hosting.server_lease import ServerLease

GOOD = """on_demand:
  - frame: chopping
    server: chopping
    launch: {package: cheffing, file: chopping.launch, arguments: {robot: pr2}}
    start_timeout_s: 20
  - frames: [folding, ironing]
    server: laundering
    run: {package: laundry, executable: fold_server.py, arguments: --fast "a & b"}
    idle_s: 5
"""


def test_both_ways_to_start() -> None:
    chopping, laundering = load_manifests(GOOD, "manifests.yaml")
    assert chopping.launch.arguments == {"robot": "pr2"} and chopping.program is None
    assert (chopping.frame_names, chopping.start_timeout_s, chopping.idle_s) == (("chopping",), 20.0, 60.0)
    assert (laundering.program.name, laundering.frame_names) == ("fold_server", ("folding", "ironing"))
    node = xml.etree.ElementTree.fromstring(laundering.program.as_launch_xml())[0]
    assert node.attrib["args"] == '--fast "a & b"' and node.attrib["type"] == "fold_server.py"


@pytest.mark.parametrize(
    "old, new, code, line",
    [
        ("frame: chopping", "frames: []\n    frame: chopping", "NO_FRAME", 2),
        ("    server: laundering", "", "MISSING_KEY", 6),
        ("    run: {", "    launch: {file: x.launch}\n    run: {", "NO_START", 6),
        ("idle_s: 5", "idle_s: forever", "NOT_A_NUMBER", 9),
        ("idle_s: 5", "idle_s: 0", "NOT_A_NUMBER", 9),
        ("folding, ironing", "folding, chopping", "DUPLICATE_FRAME", 6),
        ("file: chopping.launch, ", "", "MISSING_KEY", 4),
        ("{robot: pr2}", "pr2", "WRONG_TYPE", 4),
        ("executable: fold", "program: fold", "UNKNOWN_KEY", 8),
    ],
)
def test_mistakes_are_found_by_line(old: str, new: str, code: str, line: int) -> None:
    assert old in GOOD
    with pytest.raises(FileRefused) as refused:
        load_manifests(GOOD.replace(old, new), "manifests.yaml")
    assert (code, line) in [(problem.code, problem.line) for problem in refused.value.problems]


def test_a_frame_of_two_files_is_started_by_the_first() -> None:
    first, second = load_manifests(GOOD, "a.yaml"), load_manifests(GOOD, "b.yaml")
    chosen, doubles = by_frame(first + second)
    assert chosen["folding"].path == "a.yaml"
    assert len(doubles) == 3 and "b.yaml:2: frame 'chopping' is started by a.yaml:2 already" in doubles


def test_server_lease() -> None:
    server = ServerLease().acquired(10.0)
    assert not server.is_expired(idle_s=5.0, now_s=100.0)
    server = server.released(20.0)
    assert not server.is_expired(idle_s=5.0, now_s=24.0)
    assert server.is_expired(idle_s=5.0, now_s=25.0)
    assert not server.seen_busy(24.0).is_expired(idle_s=5.0, now_s=25.0)
    assert not server.ended().is_expired(idle_s=5.0, now_s=25.0)
    two = server.acquired(30.0).acquired(31.0).released(32.0)
    assert two.users == 1 and not two.is_expired(idle_s=1.0, now_s=99.0)
