"""The cores stay free of ROS: only the thin modules of a package import it."""

import ast
import subprocess
import sys
from pathlib import Path
from typing import Iterator, Set

import pytest

REPOSITORY = Path(__file__).resolve().parents[2]
#: Modules that may import ROS; ``ros_*.py`` too.
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
LONGEST_MODULE = 450


def product_modules() -> Iterator[Path]:
    """Every Python module of a package, without tests and without the generated or optional underlay."""
    yield from sorted(REPOSITORY.glob("src/*/src/**/*.py"))


def is_shell(path: Path) -> bool:
    return path.name in SHELL_MODULES or path.name.startswith("ros_")


def imported_packages(path: Path) -> Set[str]:
    """First components of everything that a module imports, also inside functions."""
    names: Set[str] = set()
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"), str(path))):
        if isinstance(node, ast.Import):
            names.update(alias.name.split(".")[0] for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and node.level == 0 and node.module:
            names.add(node.module.split(".")[0])
    return names


def is_ros(package: str) -> bool:
    return package in ROS_PACKAGES or package.endswith("_msgs")


@pytest.mark.parametrize(
    "path",
    [path for path in product_modules() if not is_shell(path) and path.name != "__init__.py"],
    ids=lambda path: str(path.relative_to(REPOSITORY / "src")),
)
def test_core_imports_no_ros(path: Path) -> None:
    assert not {name for name in imported_packages(path) if is_ros(name)}


@pytest.mark.parametrize(
    "package",
    [
        "spoken_quantities",
        "semantic_frames",
        "semantic_framer.framer",
        "frame_registrar.graph",
        "frame_registrar.search",
        "arbitrator.state_machine",
        "executor.goal_tracking",
        "stage_events.recent",
        "command_server.command_book",
    ],
)
def test_importing_a_core_loads_no_ros(package: str) -> None:
    code = f"import sys, {package}; sys.exit('rospy' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", code], timeout=60, check=False).returncode == 0


def test_the_check_itself_finds_an_import_of_rospy(tmp_path: Path) -> None:
    module = tmp_path / "core.py"
    module.write_text("def late():\n    from rospy import Time\n    return Time\n", encoding="utf-8")
    assert {name for name in imported_packages(module) if is_ros(name)} == {"rospy"}


@pytest.mark.parametrize("path", product_modules(), ids=lambda path: str(path.relative_to(REPOSITORY / "src")))
def test_module_fits_in_one_room(path: Path) -> None:
    assert len(path.read_text(encoding="utf-8").splitlines()) <= LONGEST_MODULE
