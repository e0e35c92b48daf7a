"""Manifests: how to start the servers that run on demand."""

from dataclasses import dataclass
from typing import Dict, List, Mapping, Optional, Sequence, Tuple
from xml.sax.saxutils import quoteattr

import yaml

from checked_files.marked_yaml import Reader, line_of

MANIFEST_KEYS = ("frame", "frames", "server", "launch", "run", "start_timeout_s", "idle_s")
LAUNCH_KEYS = ("package", "file", "arguments")
RUN_KEYS = ("package", "executable", "name", "arguments")


@dataclass(frozen=True)
class LaunchFile:
    """A launch file.

    Attributes:
        package: that holds it; empty when ``file`` is a path
        file: its name or path
        arguments: of the launch file
    """

    package: str
    file: str
    arguments: Mapping[str, str]


@dataclass(frozen=True)
class Program:
    """A program of a package.

    Attributes:
        package: that holds it
        executable: its file
        name: of the node
        arguments: on its command line
    """

    package: str
    executable: str
    name: str
    arguments: str

    def as_launch_xml(self) -> str:
        """Return a launch file that starts only this program."""
        return (
            f"<launch><node pkg={quoteattr(self.package)} type={quoteattr(self.executable)} "
            f"name={quoteattr(self.name)} args={quoteattr(self.arguments)} output={quoteattr('screen')}/></launch>"
        )


@dataclass(frozen=True)
class Manifest:
    """A server that is started when a command needs it.

    Attributes:
        server: name of the RFNServer, once it runs
        frame_names: frames that it carries out
        launch: starts it; None if a program does
        program: starts it; None if a launch file does
        start_timeout_s: deadline until it accepts goals
        idle_s: how long it is kept after its last goal
        path: the file
        line: of the file
    """

    server: str
    frame_names: Tuple[str, ...]
    launch: Optional[LaunchFile]
    program: Optional[Program]
    start_timeout_s: float
    idle_s: float
    path: str
    line: int


def load_manifests(text: str, path: str) -> Tuple[Manifest, ...]:
    """Read a manifest file: a mapping with the key ``on_demand``, a list.

    Args:
        text: content of the file
        path: where it came from, for problems
    Raises:
        FileRefused: names every mistake in the file
    """
    reader = Reader(path)
    root = reader.compose(text, "a mapping with on_demand")
    entries = reader.mapping(root, "", ("on_demand",), required=("on_demand",))
    manifests: List[Manifest] = []
    line_of_frame: Dict[str, int] = {}
    for key, item in reader.sequence(entries.get("on_demand"), "on_demand"):
        manifest = _manifest(reader, item, key, path)
        for name in manifest.frame_names:
            if name in line_of_frame:
                reader.report(
                    "DUPLICATE_FRAME", item, key, f"a second server for '{name}'", f"one, line {line_of_frame[name]}"
                )
            line_of_frame[name] = manifest.line
        manifests.append(manifest)
    reader.refuse_if_wrong()
    return tuple(manifests)


def _manifest(reader: Reader, node: yaml.Node, key: str, path: str) -> Manifest:
    entries = reader.mapping(node, key, MANIFEST_KEYS, required=("server",))
    if ("frame" in entries) == ("frames" in entries):
        reader.report("NO_FRAME", node, key, "both or none", "either 'frame' or 'frames'")
    if ("launch" in entries) == ("run" in entries):
        reader.report("NO_START", node, key, "both or none", "either 'launch' or 'run'")
    return Manifest(
        server=reader.name(entries.get("server"), f"{key}.server"),
        frame_names=reader.texts(entries.get("frame", entries.get("frames")), f"{key}.frames"),
        launch=_launch(reader, entries["launch"], f"{key}.launch") if "launch" in entries else None,
        program=_program(reader, entries["run"], f"{key}.run") if "run" in entries else None,
        start_timeout_s=reader.seconds(entries.get("start_timeout_s"), f"{key}.start_timeout_s", 30.0),
        idle_s=reader.seconds(entries.get("idle_s"), f"{key}.idle_s", 60.0),
        path=path,
        line=line_of(node),
    )


def _launch(reader: Reader, node: yaml.Node, key: str) -> LaunchFile:
    entries = reader.mapping(node, key, LAUNCH_KEYS, required=("file",))
    arguments: Dict[str, str] = {}
    if "arguments" in entries:
        given = entries["arguments"]
        if isinstance(given, yaml.MappingNode):
            arguments = {reader.name(name, key): reader.text(value, key) for name, value in given.value}
        else:
            reader.report("WRONG_TYPE", given, f"{key}.arguments", "no mapping", "a mapping of names to values")
    return LaunchFile(
        package=reader.text(entries.get("package"), f"{key}.package"),
        file=reader.name(entries.get("file"), f"{key}.file"),
        arguments=arguments,
    )


def _program(reader: Reader, node: yaml.Node, key: str) -> Program:
    entries = reader.mapping(node, key, RUN_KEYS, required=("package", "executable"))
    executable = reader.name(entries.get("executable"), f"{key}.executable")
    return Program(
        package=reader.name(entries.get("package"), f"{key}.package"),
        executable=executable,
        name=reader.text(entries.get("name"), f"{key}.name", executable.rpartition(".")[0] or executable),
        arguments=reader.text(entries.get("arguments"), f"{key}.arguments"),
    )


def by_frame(manifests: Sequence[Manifest]) -> Tuple[Dict[str, Manifest], Tuple[str, ...]]:
    """Return the manifest of each frame, and a sentence for each frame that two manifests name."""
    chosen: Dict[str, Manifest] = {}
    doubles: List[str] = []
    for manifest in manifests:
        for name in manifest.frame_names:
            if name in chosen:
                first = chosen[name]
                doubles.append(
                    f"{manifest.path}:{manifest.line}: frame '{name}' is started by {first.path}:{first.line} already"
                )
            else:
                chosen[name] = manifest
    return chosen, tuple(doubles)
