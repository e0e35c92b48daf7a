"""Layers: cores import no ROS, stages import no other stage, and no modules import each other in a circle."""

import ast
import re
import subprocess
import sys
from pathlib import Path
from typing import Dict, Iterator, List, Set

import pytest

from roboframenet_testing.recorded_parses import NotRecorded
from roboframenet_testing.workspace import REPOSITORY, imports, modules, package, package_name, packages
from stanford_parser_ros.model import shipped_parser

#: Modules that may import ROS, besides ``ros_*.py``.
SHELL_MODULES = {"node.py", "rfnserver.py"}
ROS_PACKAGES = {
    "rospy",
    "actionlib",
    "roslib",
    "rosgraph",
    "roslaunch",
    "rosservice",
    "rostopic",
    "rosnode",
    "tf2_ros",
    "dynamic_reconfigure",
    "smach_ros",
    "genpy",
    "message_filters",
}
LONGEST_CLASS = 250
#: Packages that understand what is said.
LANGUAGE = (
    "utterance_passes semantic_framer semantic_frames phrase_meanings semantic_types word_classes spoken_quantities "
    "typed_arguments referring_expressions question_answering condition_watchers stanford_parser_ros"
).split()


def product_modules() -> Iterator[Path]:
    """Return all Python modules of our packages, without tests, generated code and the underlay."""
    yield from modules().values()


def modules_imported(path: Path, known: Set[str]) -> Set[str]:
    """Return those of our modules that a module imports, also inside functions."""
    return set(imports(path) & known)


def circle(graph: Dict[str, Set[str]]) -> List[str]:
    """Return nodes of which each leads to the next and the last to the first; none if there is no circle."""
    left = {name: set(names) for name, names in graph.items()}
    while True:
        ends = {name for name, names in left.items() if not names & set(left)}
        if not ends:
            break
        left = {name: names for name, names in left.items() if name not in ends}
    found: List[str] = []
    name = min(left, default="")
    while name and name not in found:
        found.append(name)
        name = min(left[name] & set(left))
    return found[found.index(name) :] if name else []


def is_shell(path: Path) -> bool:
    return path.name in SHELL_MODULES or path.name.startswith("ros_")


def imported_packages(path: Path) -> Set[str]:
    """Return the top-level names that a module imports, also inside functions."""
    return {name.split(".")[0] for name in imports(path)}


def is_ros(package: str) -> bool:
    return package in ROS_PACKAGES or package.endswith("_msgs")


def test_cores_import_no_ros() -> None:
    cores = [path for path in product_modules() if not is_shell(path) and path.name != "__init__.py"]
    assert len(cores) > 300
    importing = [(str(path), name) for path in cores for name in imported_packages(path) if is_ros(name)]
    assert importing == []


CORES = (
    "spoken_quantities",
    "semantic_frames",
    "word_classes",
    "typed_arguments",
    "utterance_passes.table",
    "semantic_framer.framer",
    "offline_pipeline.pipeline",
    "frame_registrar.graph",
    "frame_registrar.search",
    "arbitrator.state_machine",
    "executor.goal_tracking",
    "robot_stop.braking",
    "robot_stop.servers",
    "roboframenet_ros.deadline",
    "roboframenet_ros.log_thread",
    "roboframenet_ros.parameters",
    "roboframenet_ros.recent",
    "roboframenet_testing",
    "roboframenet_ros.suspension",
    "stop_server.other_answers",
    "command_server.open_commands",
)


def test_importing_a_core_loads_no_ros() -> None:
    """One after the other in one process: the first one that loads it is named."""
    code = "import importlib, sys\nfor name in sys.argv[1:]:\n    importlib.import_module(name)\n    "
    code += "'rospy' in sys.modules and sys.exit(name)"
    run = subprocess.run(
        [sys.executable, "-c", code, *CORES], stderr=subprocess.PIPE, text=True, timeout=60, check=False
    )
    assert run.returncode == 0, run.stderr


def test_no_modules_import_each_other_in_a_circle() -> None:
    paths = modules()
    graph = {name: modules_imported(path, set(paths)) - {name} for name, path in paths.items()}
    assert sum(map(len, graph.values())) > 100
    assert circle(graph) == []


def test_a_circle_is_found() -> None:
    assert circle({"a": {"b"}, "b": {"c"}, "c": {"b"}, "d": set()}) == ["b", "c"]
    assert circle({"a": {"b"}, "b": set()}) == []


def test_only_tests_depend_on_the_package_for_tests() -> None:
    for_tests = {"roboframenet_testing", "roboframenet_rostest"}
    importing = [path for path in product_modules() if for_tests & set(imported_packages(path))]
    assert {package_name(path) for path in importing} == for_tests
    for name, folder in packages("src", "underlay").items():
        text = (folder / "package.xml").read_text(encoding="utf-8")
        kinds = re.findall(r"<(\w+)[^>]*>roboframenet_(?:testing|rostest)<", text)
        assert set(kinds) <= {"test_depend", "name"} or name in for_tests | {"roboframenet"}, name


#: The one file of the tier "test" that depends on the models.
WITH_MODELS = package("stanford_parser_ros") / "test" / "unit" / "test_model.py"


def files_of_unit_tests() -> Iterator[Path]:
    """What ``make test`` runs with pytest, with the modules that it imports from beside it."""
    for folder in [*(one / "test" / "unit" for one in packages().values()), REPOSITORY / "tests" / "unit"]:
        yield from sorted(folder.glob("**/*.py"))


def loads_models(path: Path) -> bool:
    """Return whether a module imports Stanza, or names a class that loads the models.

    ``shipped_parser`` does not count: in unit tests, recorded answers are behind it.
    """
    text = path.read_text(encoding="utf-8")
    if not re.search("JointInference|StanzaInference|stanza|torch", text):
        return False
    names = {
        getattr(node, "id", getattr(node, "attr", getattr(node, "name", ""))) for node in ast.walk(ast.parse(text))
    }
    return bool(names & {"JointInference", "StanzaInference"}) or bool(imported_packages(path) & {"stanza", "torch"})


def test_one_file_of_unit_tests_loads_the_models() -> None:
    assert [path for path in files_of_unit_tests() if loads_models(path)] == [WITH_MODELS]


@pytest.mark.parametrize(
    "line",
    [
        "from stanford_parser_ros.inference import StanzaInference as Models",
        "from stanford_parser_ros.joint.inference import JointInference as Models",
        "from stanford_parser_ros import inference\nmodels = inference.StanzaInference(model_dir=folder)",
        "def late():\n    import stanza.pipeline",
        "import torch",
    ],
)
def test_what_loads_the_models_is_found(tmp_path: Path, line: str) -> None:
    module = tmp_path / "test_something.py"
    module.write_text("from stanford_parser_ros.model import shipped_parser\n", encoding="utf-8")
    assert not loads_models(module)
    module.write_text(line, encoding="utf-8")
    assert loads_models(module)


def test_recorded_answers_are_behind_the_shipped_parser(request: "pytest.FixtureRequest") -> None:
    if request.config.getoption("record"):
        pytest.skip("the models answer while they are recorded")
    parser = shipped_parser()
    with pytest.raises(NotRecorded, match="'make record'"):
        parser.parse("Nobody has ever said these words in a test of this project.")


def test_an_import_of_rospy_is_found(tmp_path: Path) -> None:
    module = tmp_path / "core.py"
    module.write_text("def late():\n    from rospy import Time\n    return Time\n", encoding="utf-8")
    assert {name for name in imported_packages(module) if is_ros(name)} == {"rospy"}


def test_classes_of_the_language_have_at_most_250_lines() -> None:
    found = set()
    for name in LANGUAGE:
        for path in package(name).glob("src/**/*.py"):
            text = path.read_text(encoding="utf-8")
            for node in ast.parse(text).body if text.count("\n") >= LONGEST_CLASS else ():
                if isinstance(node, ast.ClassDef) and (node.end_lineno or 0) - node.lineno >= LONGEST_CLASS:
                    found.add(f"{name}: {node.name}")
    assert found == set()


PACKAGES = list(packages().values())
#: Stages pass commands on by topics. Exceptions: the executor runs the plan and the machine that the arbitrator builds,
#: and the framer reads the parse with the types of the parser.
STAGES = {"command_server", "stanford_parser_ros", "semantic_framer", "frame_registrar", "arbitrator", "executor"}
ARROWS_BETWEEN_STAGES = {("executor", "arbitrator"), ("semantic_framer", "stanford_parser_ros")}


def packages_imported(package: Path) -> Set[str]:
    """Return those of our packages that a package imports."""
    paths = package.glob("src/**/*.py")
    names: Set[str] = set().union(*(imported_packages(path) for path in paths))
    return names & {other.name for other in PACKAGES} - {package.name}


def test_a_stage_imports_no_other_stage() -> None:
    arrows = {(package.name, other) for package in PACKAGES for other in packages_imported(package)}
    assert {arrow for arrow in arrows if set(arrow) <= STAGES} == ARROWS_BETWEEN_STAGES


def test_groups_of_packages_use_each_other_one_way() -> None:
    def group(package: Path) -> str:
        return package.name if package.parent == REPOSITORY / "src" else package.parent.name

    groups = {package.name: group(package) for package in PACKAGES}
    graph: Dict[str, Set[str]] = {}
    for one in PACKAGES:
        below = {groups[other] for other in packages_imported(one)}
        graph.setdefault(group(one), set()).update(below - {group(one)})
    assert "semantic_framer" in graph["pipeline"]
    assert circle(graph) == []


def test_roboframenet_ros_imports_only_messages() -> None:
    assert packages_imported(package("roboframenet_ros")) == {"roboframenet_msgs"}


@pytest.mark.parametrize("package", PACKAGES, ids=lambda package: package.name)
def test_package_xml_names_what_is_imported(package: Path) -> None:
    text = (package / "package.xml").read_text(encoding="utf-8")
    assert {name for name in packages_imported(package) if f"depend>{name}<" not in text} == set()


def internal_imports(name: str) -> Dict[str, Set[str]]:
    """Return the modules of the same package that each module of a package imports."""
    paths = {one: path for one, path in modules().items() if one.startswith(f"{name}.") and path.name != "__init__.py"}
    return {one: modules_imported(path, set(paths)) - {one} for one, path in paths.items()}


def levels(graph: Dict[str, Set[str]]) -> Dict[str, int]:
    """Return the level of each module: 1 for one that imports no other.

    Raises:
        ValueError: modules import each other in a circle
    """
    found: Dict[str, int] = {}
    while len(found) < len(graph):
        next_ones = [name for name in graph if name not in found and graph[name] <= set(found)]
        if not next_ones:
            raise ValueError(f"a circle among {sorted(set(graph) - set(found))}")
        found.update({name: 1 + max((found[other] for other in graph[name]), default=0) for name in next_ones})
    return found


# The two largest packages have rooms, and test_rooms.py counts their floors.
@pytest.mark.parametrize("name, most", [("utterance_passes", 7), ("offline_pipeline", 3)])
def test_packages_have_few_levels(name: str, most: int) -> None:
    floors = levels(internal_imports(name))
    assert max(floors.values()) <= most, sorted(floors.items(), key=lambda item: item[1])


def test_a_circle_of_modules_is_found() -> None:
    with pytest.raises(ValueError, match="circle"):
        levels({"one": {"other"}, "other": {"one"}, "alone": set()})
