"""The graph of frames: adding, replacing, registering."""

import networkx
import pytest

from frame_registrar import graph as graph_module
from frame_registrar.graph import FrameGraph
from semantic_frames import FileRefused, load_frame


def frame(text: str, path: str = "x.yaml"):
    return load_frame(text, path)


A = "name: a\nframe_elements: [{name: x}]\nchildren: [{name: b}]\n"


def test_same_file_twice_changes_nothing() -> None:
    graph = FrameGraph()
    assert graph.add(frame(A)) and not graph.add(frame(A))


def test_changed_file_takes_the_place_of_the_old_one() -> None:
    graph = FrameGraph()
    graph.add(frame(A))
    graph.add(frame("name: a\ndescription: new\n"))
    assert graph.frames["a"].description == "new"
    assert graph.descendants("a") == ()


def test_cycle_is_refused_by_its_names_and_the_graph_stays() -> None:
    graph = FrameGraph()
    graph.add(frame(A))
    graph.add(frame("name: b\nchildren: [{name: c}]\n"))
    with pytest.raises(FileRefused) as refused:
        graph.add(frame("name: c\nchildren:\n  - name: a\n", "c.yaml"))
    problem = refused.value.problems[0]
    assert (problem.code, problem.path, problem.line) == ("CYCLE", "c.yaml", 3)
    assert problem.found == "c -> a -> b -> c"
    assert "c" not in graph.frames


def test_frame_that_is_its_own_child_is_a_cycle() -> None:
    with pytest.raises(FileRefused, match="a -> a"):
        FrameGraph().add(frame("name: a\nchildren: [{name: a}]\n"))


def test_replacing_a_frame_may_break_what_was_a_cycle() -> None:
    graph = FrameGraph()
    graph.add(frame(A))
    graph.add(frame("name: a\n"))
    assert graph.add(frame("name: b\nchildren: [{name: a}]\n"))


def test_unknown_element_of_a_child_is_refused_whichever_comes_last() -> None:
    parent = frame(
        "name: p\nframe_elements: [{name: x}]\nchildren:\n  - name: c\n    frame_element_relations:\n"
        "      - {parent_name: x, child_name: thme}\n",
        "p.yaml",
    )
    child = frame("name: c\nframe_elements: [{name: theme}]\n", "c.yaml")
    for first, second in ((parent, child), (child, parent)):
        graph = FrameGraph()
        graph.add(first)
        with pytest.raises(FileRefused, match="did you mean 'theme'"):
            graph.add(second)


def test_registering_before_the_file_comes_counts_when_it_comes() -> None:
    graph = FrameGraph()
    assert graph.register("later", "server") == ()
    graph.add(frame("name: later\n"))
    assert graph.servers("later") == ("server",)


def test_registering_twice_changes_nothing() -> None:
    graph = FrameGraph()
    graph.register("a", "server")
    graph.register("a", "server")
    assert graph.registrations() == (("a", "server"),)


@pytest.mark.parametrize("name, server", [("", "server"), ("a", " ")])
def test_registration_without_a_name_is_refused(name: str, server: str) -> None:
    assert FrameGraph().register(name, server)


def test_dead_server_is_offered_again_when_it_is_back() -> None:
    graph = FrameGraph()
    graph.register("a", "server")
    assert graph.set_dead(frozenset(["server"])) and graph.servers("a") == ()
    assert not graph.set_dead(frozenset(["server"]))
    assert graph.set_dead(frozenset()) and graph.servers("a") == ("server",)


def test_unknown_children_are_told() -> None:
    graph = FrameGraph()
    graph.add(frame(A))
    assert [problem.found for problem in graph.unknown_children()] == ["'b'"]


def test_removed_frame_may_come_again() -> None:
    graph = FrameGraph()
    graph.add(frame(A))
    graph.register("a", "server")
    graph.remove("a")
    assert graph.frame("a") is None and graph.descendants("a") == ()
    graph.remove("a")
    assert graph.add(frame(A)) and graph.servers("a") == ("server",) and graph.descendants("a") == ("b",)


def test_adding_a_frame_looks_at_its_relatives_only(monkeypatch: pytest.MonkeyPatch) -> None:
    graph = FrameGraph()
    for number in range(100):
        graph.add(frame(f"name: f{number}\nchildren: [{{name: f{number + 1}}}]\n"))
    checked = []
    check = graph_module._relation_problems
    monkeypatch.setattr(
        graph_module, "_relation_problems", lambda *about: checked.append(about[0].name) or check(*about)
    )
    monkeypatch.setattr(networkx.DiGraph, "copy", lambda _: pytest.fail("the whole graph is copied"))
    graph.add(frame("name: f50\ndescription: new\nchildren: [{name: f51}]\n"))
    assert checked == ["f50", "f49"]


def test_refused_frame_leaves_its_relations_alone() -> None:
    graph = FrameGraph()
    graph.add(frame(A))
    graph.add(frame("name: b\nchildren: [{name: c}]\n"))
    with pytest.raises(FileRefused):
        graph.add(frame("name: b\nchildren: [{name: d}, {name: a}]\n"))
    assert graph.descendants("b") == ("c",)
    assert graph.add(frame("name: d\nchildren: [{name: b}]\n"))


@pytest.mark.parametrize("name", ["x" * 201, "two\nlines", "\x1b[2J"])
def test_names_that_are_no_names_are_refused(name: str) -> None:
    for about in ((name, "server"), ("frame", name)):
        (error,) = FrameGraph().register(*about)
        assert "printable" in error
        assert error.isprintable()
        assert len(error) < 200


def test_registrations_are_limited_and_dead_servers_make_room(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(graph_module, "MOST_REGISTRATIONS", 3)
    graph = FrameGraph()
    for server in "abc":
        assert graph.register("f", server) == ()
    assert graph.register("f", "d") == ("there are 3 registrations already",)
    assert graph.register("f", "a") == ()
    graph.set_dead(frozenset("b"))
    assert graph.register("f", "d") == ()
    assert graph.registrations() == (("f", "a"), ("f", "c"), ("f", "d"))


def test_frames_are_limited(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(graph_module, "MOST_FRAMES", 1)
    graph = FrameGraph()
    graph.add(frame("name: a\n"))
    with pytest.raises(FileRefused, match="TOO_MANY"):
        graph.add(frame("name: b\n"))
    assert graph.add(frame("name: a\ndescription: new\n"))
