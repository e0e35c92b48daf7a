"""``rfn graph``: the graph of semantic frames as SVG or dot."""

import argparse
import sys
from typing import Dict, List, Mapping, Tuple
from xml.sax.saxutils import escape

from frame_registrar.graph import FrameGraph
from offline_pipeline.knowledge import load_knowledge, shipped_domains
from roboframenet_tools.folders import folders_of

EXAMPLES = """examples:
  rfn graph --svg frames.svg
  rfn graph --dot - | dot -Tpdf > frames.pdf
"""
#: Below the graph.
LEGEND = "dashed: this frame alone can stand for its parent; 1.2: the second step of the first sequence"


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the arguments of ``rfn graph``."""
    parser.epilog = EXAMPLES
    parser.add_argument(
        "--domains", action="append", metavar="FOLDER[,FOLDER]", help="folders of frames (default: those shipped)"
    )
    form = parser.add_mutually_exclusive_group(required=True)
    form.add_argument("--svg", metavar="FILE", help="write SVG; '-' for standard output")
    form.add_argument("--dot", metavar="FILE", help="write the language of Graphviz; '-' for standard output")


def run(arguments: argparse.Namespace) -> int:
    """Write the graph; return the exit status."""
    try:
        folders = folders_of(arguments.domains or ()) or [shipped_domains()]
    except NotADirectoryError as error:
        print(f"rfn graph: {error}", file=sys.stderr)
        return 2
    knowledge = load_knowledge(folders)
    text, path = (svg(knowledge.graph), arguments.svg) if arguments.svg else (dot(knowledge.graph), arguments.dot)
    if path == "-":
        sys.stdout.write(text)
        return 0
    try:
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
    except OSError as error:
        print(f"rfn graph: {error}", file=sys.stderr)
        return 2
    return 0


def dot(graph: FrameGraph) -> str:
    """Return the graph for Graphviz. Steps of a sequence are numbered; a frame that alone stands for its parent is
    dashed.
    """
    lines = ["digraph frames {", "  rankdir=LR; node [shape=box, fontname=sans];"]
    lines.append(f'  label="{LEGEND}"; fontname=sans;')
    lines += [f'  "{name}";' for name in graph.frames]
    for parent, child, label in _edges(graph):
        lines.append(
            f'  "{parent}" -> "{child}" [label="{label}"];' if label else f'  "{parent}" -> "{child}" [style=dashed];'
        )
    return "\n".join(lines + ["}"]) + "\n"


def _edges(graph: FrameGraph) -> List[Tuple[str, str, str]]:
    """Yield parent, child, and for a sequence its number and the step in it: "1.2"."""
    return [
        (frame.name, child.name, f"{number}.{step}" if len(sequence) > 1 else "")
        for frame in graph.frames.values()
        for number, sequence in enumerate(frame.children, start=1)
        for step, child in enumerate(sequence, start=1)
    ]


def layers(graph: FrameGraph) -> Dict[str, int]:
    """Return the length of the longest path to each frame; the graph has no cycle."""
    parents: Dict[str, List[str]] = {}
    names = list(graph.frames)
    for parent, child, _ in _edges(graph):
        parents.setdefault(child, []).append(parent)
        names.append(child)
    found: Dict[str, int] = {}
    for name in dict.fromkeys(names):
        _layer(name, parents, found)
    return found


def _layer(name: str, parents: Mapping[str, List[str]], found: Dict[str, int]) -> int:
    if name not in found:
        found[name] = max((1 + _layer(parent, parents, found) for parent in parents.get(name, ())), default=0)
    return found[name]


def svg(graph: FrameGraph) -> str:
    """Return the graph as SVG, with parents to the left of their children, and frames without relations in the last
    column."""
    edges = _edges(graph)
    related = {name for parent, child, _ in edges for name in (parent, child)}
    layer = layers(graph)
    last = max((layer[name] for name in related), default=-1) + 1
    rows: Dict[int, int] = {}
    place = {}
    for name in sorted(layer):
        column = layer[name] if name in related else last
        place[name] = (20 + 240 * column, 20 + 34 * rows.get(column, 0))
        rows[column] = rows.get(column, 0) + 1
    width, height = max(640, 20 + 240 * (last + 1)), 64 + 34 * max(rows.values(), default=0)
    parts = [
        (
            f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}"'
            ' font-family="sans-serif" font-size="12">'
        )
    ]
    parts.append(f'<text x="20" y="{height - 12}" fill="#456">{LEGEND}</text>')
    for parent, child, label in edges:
        (x, y), (to_x, to_y) = place[parent], place[child]
        dash = "" if label else ' stroke-dasharray="4 3"'
        parts.append(f'<path d="M{x + 180},{y + 12} L{to_x},{to_y + 12}" stroke="#456" fill="none"{dash}/>')
        if label:
            parts.append(f'<text x="{to_x - 20}" y="{to_y + 8}" font-size="9" fill="#456">{label}</text>')
    for name, (x, y) in place.items():
        parts.append(f'<rect x="{x}" y="{y}" width="180" height="24" rx="4" fill="#eef3f8" stroke="#456"/>')
        parts.append(f'<text x="{x + 90}" y="{y + 16}" text-anchor="middle">{escape(name)}</text>')
    return "\n".join(parts + ["</svg>"]) + "\n"
