"""Checking, counting, drawing and making files."""

import subprocess
import sys
from types import SimpleNamespace
from xml.etree import ElementTree

import pytest

from offline_pipeline.file_checks import find_problems, load_paths
from roboframenet_tools import doctor, new
from roboframenet_tools.cli import COMMANDS, OUTPUT_CLOSED, main
from roboframenet_tools.completion import script
from roboframenet_tools.graph import dot, layers, svg
from roboframenet_tools.listing import count, is_grounded, table


def write(folder, name, text):
    (folder / "frames").mkdir(exist_ok=True)
    (folder / "frames" / f"{name}.yaml").write_text(text)


@pytest.fixture
def chain(tmp_path):
    write(tmp_path, "a", "name: a\nchildren:\n  - name: b\n")
    write(tmp_path, "b", "name: b\n")
    return tmp_path


def test_unknown_child_has_its_line(tmp_path):
    write(tmp_path, "a", "name: a\nchildren:\n  - name: nowhere\n")
    (problem,) = find_problems(*load_paths([str(tmp_path)]))
    assert (problem.code, problem.line) == ("UNKNOWN_FRAME", 3)


def test_cycle_and_duplicate(chain):
    write(chain, "b", "name: b\nchildren:\n  - name: a\n")
    write(chain, "c", "name: a\n")
    assert {problem.code for problem in find_problems(*load_paths([str(chain)]))} == {"CYCLE", "DUPLICATE_FRAME"}


def test_scaffold_passes_the_check_and_is_not_overwritten(tmp_path, capsys):
    words = ["new", "waving", "--verb", "wave", "--folder", str(tmp_path)]
    assert main(words) == 0
    assert main(words) == 1
    knowledge, checked = load_paths([str(tmp_path)])
    assert len(checked) == 2
    assert find_problems(knowledge, checked) == []
    compile((tmp_path / "nodes" / "waving_server").read_text(), "waving_server", "exec")


@pytest.mark.parametrize("name", ["Waving", "1a", "../x", ""])
def test_scaffold_refuses_names(name):
    with pytest.raises(ValueError):
        new.scaffold(name, "wave")


def test_grounded_through_a_child(chain):
    knowledge, _ = load_paths([str(chain)])
    assert not is_grounded(knowledge.graph, "a")
    knowledge.graph.register("b", "b")
    assert is_grounded(knowledge.graph, "a")
    (domain,) = count(knowledge, knowledge.graph)
    assert (domain.frames, domain.units, domain.grounded) == (2, 0, 2)
    assert "52" in table([domain], ("pr2",))


def test_drawings(chain):
    graph = load_paths([str(chain)])[0].graph
    assert layers(graph) == {"a": 0, "b": 1}
    assert '"a" -> "b"' in dot(graph)
    ElementTree.fromstring(svg(graph))


def test_completion_is_bash():
    text = script()
    assert all(name in text for name, _, _ in COMMANDS)
    subprocess.run(["bash", "-n"], input=text, text=True, check=True, timeout=20)


def test_doctor_says_what_to_do(monkeypatch):
    monkeypatch.delenv("ROS_HOSTNAME", raising=False)
    monkeypatch.delenv("ROS_IP", raising=False)
    assert "->" in str(doctor.host_name())
    monkeypatch.setattr(doctor, "sys", SimpleNamespace(version_info=(3, 7), version="3.7.0 x", executable="python"))
    assert doctor.interpreter().advice


@pytest.mark.parametrize("words", [["list"], ["--help"], ["list", "--help"]])
def test_output_that_nobody_reads_ends_quietly(words):
    code = "import sys; from roboframenet_tools.cli import main; sys.exit(main(sys.argv[1:]))"
    reader = subprocess.Popen([sys.executable, "-c", ""], stdin=subprocess.PIPE)
    reader.wait(timeout=60)
    result = subprocess.run(
        [sys.executable, "-c", code, *words],
        stdout=reader.stdin,
        stderr=subprocess.PIPE,
        text=True,
        timeout=120,
        check=False,
    )
    reader.stdin.close()
    assert (result.returncode, result.stderr) == (OUTPUT_CLOSED, "")
