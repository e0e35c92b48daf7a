"""Checking, counting, drawing and making files."""

import re
import subprocess
import sys
from types import SimpleNamespace
from xml.etree import ElementTree

import pytest

from frame_registrar.graph import FrameGraph
from offline_pipeline.file_checks import find_problems, load_paths
from roboframenet_tools import doctor
from roboframenet_tools.cli import COMMANDS, OUTPUT_CLOSED, main
from roboframenet_tools.completion import script
from roboframenet_tools.graph import LEGEND, dot, layers, svg
from roboframenet_tools.listing import count, is_grounded, table, table_of_robots
from roboframenet_tools.registrations import Registered, registration_findings
from roboframenet_tools.verb_forms import verb_of
from semantic_frames import load_frame
from semantic_frames.server_profile import Purpose, ServerProfile
from voice_recognition import whisper_model
from voice_recognition.engines import Engine, chosen


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


def test_a_file_of_names_is_checked(tmp_path):
    path = tmp_path / "names.yaml"
    path.write_text("names:\n  Anna: Human\n  butler: Devce\n")
    (problem,) = find_problems(*load_paths([str(path)]))
    assert (problem.code, problem.line, problem.key) == ("UNKNOWN_TYPE", 3, "names.butler")


def test_cycle_and_duplicate(chain):
    write(chain, "b", "name: b\nchildren:\n  - name: a\n")
    write(chain, "c", "name: a\n")
    assert {problem.code for problem in find_problems(*load_paths([str(chain)]))} == {"CYCLE", "DUPLICATE_FRAME"}


def test_scaffold_passes_the_check_and_is_not_overwritten(tmp_path, capsys):
    words = ["new", "winking", "--verb", "wink", "--folder", str(tmp_path)]
    assert main(words) == 0
    assert main(words) == 1
    knowledge, checked = load_paths([str(tmp_path)])
    assert len(checked) == 2
    assert find_problems(knowledge, checked) == []
    compile((tmp_path / "nodes" / "winking_server").read_text(), "winking_server", "exec")


def test_verb_comes_from_the_name_and_next_steps_are_said(tmp_path, capsys):
    assert main(["new", "winking", "--folder", str(tmp_path)]) == 0
    printed = capsys.readouterr().out
    assert 'The verb is "wink".' in printed
    assert f"rfn check --examples {tmp_path}" in printed
    assert "verb: [wink]" in (tmp_path / "lexical_units" / "winking.yaml").read_text()


def test_new_refuses_a_frame_that_exists_and_warns_of_a_verb(tmp_path, capsys):
    assert main(["new", "turning", "--folder", str(tmp_path)]) == 1
    assert "the frame 'turning' exists already" in capsys.readouterr().err
    assert not list(tmp_path.iterdir())
    assert main(["new", "turning_pages", "--verb", "turn", "--folder", str(tmp_path)]) == 0
    assert "'turn' evokes" in capsys.readouterr().err


def test_new_package_and_a_second_ability(tmp_path, capsys):
    package = tmp_path / "my_robot"
    assert main(["new", "winking", "--package", str(package)]) == 0
    assert ElementTree.parse(package / "package.xml").findtext("name") == "my_robot"
    node = ElementTree.parse(package / "launch" / "my_robot.launch").find("node")
    assert (node.get("pkg"), node.get("type")) == ("my_robot", "winking_server")
    test = ElementTree.parse(package / "test" / "rostest" / "winking.test").find("test").get("type")
    for program in ("nodes/winking_server", f"test/rostest/{test}"):
        assert (package / program).stat().st_mode & 0o111
        compile((package / program).read_text(), program, "exec")
    assert main(["new", "juggling", "--verb", "juggle", "--package", str(package)]) == 0
    assert 'type="juggling_server"' in capsys.readouterr().out
    knowledge, checked = load_paths([str(package)])
    assert (len(checked), find_problems(knowledge, checked)) == (4, [])


def test_new_from_an_action_fills_its_fields(tmp_path):
    words = ["new", "computing", "--from-action", "actionlib_tutorials/Fibonacci.action", "--folder", str(tmp_path)]
    assert main(words) == 0
    knowledge, checked = load_paths([str(tmp_path)])
    assert find_problems(knowledge, checked) == []
    (element,) = knowledge.frames["computing"].frame_elements
    assert (element.name, element.is_core) == ("order", True)
    server = (tmp_path / "nodes" / "computing_server").read_text()
    compile(server, "computing_server", "exec")
    assert 'RFNServer("computing", FibonacciAction, execute_cb=execute' in server


def test_new_from_an_action_without_fields_needs_no_elements(tmp_path):
    words = ["new", "mapping", "--from-action", "nav_msgs/GetMap.action", "--package", str(tmp_path / "mapper")]
    assert main(words) == 0
    knowledge, checked = load_paths([str(tmp_path)])
    assert find_problems(knowledge, checked) == []
    assert knowledge.frames["mapping"].frame_elements == ()
    (unit,) = [unit for unit in knowledge.lexicon.units if unit.frame_name == "mapping"]
    assert [example.text for example in unit.examples] == ["Map.", "please map", "Could you map?"]


def test_particle_of_a_new_verb_may_be_a_preposition(tmp_path):
    assert main(["new", "looking_after", "--verb", "look after", "--folder", str(tmp_path)]) == 0
    assert "elements:\n  theme: [dobj, prep_after]\n" in (tmp_path / "lexical_units" / "looking_after.yaml").read_text()


def test_new_from_an_action_takes_constants_as_values(tmp_path):
    words = ["new", "testing", "--from-action", "actionlib/TestRequest.action", "--folder", str(tmp_path)]
    assert main(words) == 0
    knowledge, _ = load_paths([str(tmp_path)])
    elements = {element.name: element for element in knowledge.frames["testing"].frame_elements}
    assert "aborted" in elements["terminate_status"].values
    assert elements["the_result"].quantity is not None and not elements["the_result"].values
    (unit,) = knowledge.lexicon.whole_units(knowledge.frames)
    relations = {relation.name: [str(path) for path in relation.relations] for relation in unit.relations}
    assert relations["pause_status"] == ["measure"]


def test_new_from_no_action_is_wrong_usage(tmp_path, capsys):
    words = ["new", "counting", "--folder", str(tmp_path), "--from-action"]
    assert main([*words, "actionlib_tutorials/Nothing.action"]) == 2
    assert "no action type actionlib_tutorials/NothingAction" in capsys.readouterr().err
    assert main([*words, "Nothing"]) == 2
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("name", ["Waving", "1a", "../x", "", "all_of_it"])
def test_new_refuses_names(name, tmp_path):
    assert main(["new", name, "--folder", str(tmp_path)]) == 2
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    "name, verb",
    [
        ("waving", "wave"),
        ("moving_forward", "move"),
        ("navigating_to_location", "navigate"),
        ("running", "run"),
        ("turning", "turn"),
        ("handling", "handle"),
        ("beckoning", "beckon"),
        ("rescuing", "rescue"),
        ("lying", "lie"),
        ("wave", "wave"),
        ("home_all", None),
        ("sing", "sing"),
    ],
)
def test_verb_in_the_name_of_a_frame(name, verb):
    assert verb_of(name) == verb


def test_a_known_verb_comes_first():
    assert verb_of("bathing") == "bath"
    assert verb_of("bathing", {"bathe"}.__contains__) == "bathe"


def test_grounded_through_a_child(chain):
    knowledge, _ = load_paths([str(chain)])
    assert not is_grounded(knowledge.graph, "a")
    knowledge.graph.register("b", "b")
    assert is_grounded(knowledge.graph, "a")
    (domain,) = count(knowledge, knowledge.graph)
    assert (domain.frames, domain.units, domain.grounded) == (2, 0, 2)
    assert "52" in table([domain], ("pr2",))


def test_grounded_by_who_watches(chain):
    knowledge, _ = load_paths([str(chain)])
    knowledge.graph.register("b", "b", ServerProfile(purpose=Purpose.WATCHES))
    assert is_grounded(knowledge.graph, "b")


def test_drawings(chain):
    graph = load_paths([str(chain)])[0].graph
    assert layers(graph) == {"a": 0, "b": 1}
    assert '"a" -> "b"' in dot(graph)
    texts = [element.text for element in ElementTree.fromstring(svg(graph)).iter() if element.text]
    assert LEGEND in texts
    assert LEGEND in dot(graph)


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


def test_doctor_tells_whether_agents_can_command_the_robot():
    assert "needs Python 3.10" in str(doctor.agents((3, 8, 10)))
    assert "make agents" in str(doctor.agents((3, 11, 2), "no_such_sdk"))
    assert str(doctor.agents((3, 11, 2), "json")).endswith("agent_server can run")
    assert not any(doctor.agents(version, "no_such_sdk").advice for version in ((3, 8), (3, 11)))


def test_doctor_tells_which_recogniser_hears(monkeypatch):
    assert str(doctor.voice(Engine.POCKETSPHINX)).endswith("pocketsphinx hears")
    if chosen(Engine.AUTO)[0] is Engine.WHISPER:
        assert re.search(r"Whisper hears: loaded in \d+\.\d s, [1-9]\d+ MB", str(doctor.voice()))
    monkeypatch.setattr(whisper_model, "PACKAGE", "no_such_package")
    finding = doctor.voice()
    assert "no_such_package" in str(finding) and "make voice" in str(finding) and not finding.advice


def test_doctor_sees_servers_of_unknown_frames_and_dead_ones():
    (fine,) = registration_findings(["turning"], [Registered("turning", "turning", True)])
    assert not fine.advice
    typo, dead = registration_findings(
        ["broadcasting", "turning"], [Registered("brodcasting", "tts", True), Registered("turning", "turning", False)]
    )
    assert "did you mean 'broadcasting'" in typo.advice
    assert "does not answer" in dead.found and dead.advice


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
    # The argparse of newer Pythons keeps to itself that nobody read the help.
    allowed = (OUTPUT_CLOSED, 0) if "--help" in words else (OUTPUT_CLOSED,)
    assert result.returncode in allowed and result.stderr == ""


@pytest.mark.parametrize(
    "words, advice",
    [
        (["sya", "Turn left."], "Did you mean 'say'?"),
        (["trun", "left"], 'rfn say "trun left"'),
        (["Turn left."], 'rfn say "Turn left."'),
        (["xyzzy"], "'rfn --help' lists them"),
    ],
)
def test_what_is_no_command_is_told_with_what_was_meant(capsys, words, advice):
    assert main(words) == 2
    assert advice in capsys.readouterr().err


@pytest.mark.parametrize("words", [["help"], ["help", "new"]])
def test_help_is_a_command_too(capsys, words):
    with pytest.raises(SystemExit) as ended:
        main(words)
    assert ended.value.code == 0
    assert "usage: rfn" in capsys.readouterr().out


def test_list_shows_which_robot_can_do_what() -> None:
    graph = FrameGraph()
    for name in ("turning", "dancing", "pinging"):
        graph.add(load_frame(f"name: {name}\n", f"{name}.yaml"))
    graph.register("turning", "/alpha/turning", ServerProfile(robot="alpha"))
    graph.register("turning", "/beta/turning", ServerProfile(robot="beta"))
    graph.register("dancing", "/beta/dancing", ServerProfile(robot="beta"))
    graph.register("pinging", "ping")
    assert [line.split(None, 2) for line in table_of_robots(graph).splitlines()] == [
        ["robots", "grounded", "frames"],
        ["alpha", "2", "pinging, turning"],
        ["beta", "3", "dancing, pinging, turning"],
    ]
    assert not table_of_robots(FrameGraph())
