"""Pictures as values: shapes with attributes. The page makes SVG elements of them, `as_svg` a file."""

from dataclasses import dataclass
from typing import Tuple
from xml.sax.saxutils import escape, quoteattr

#: All that a picture may contain; the page makes nothing else either.
TAGS = ("path", "text", "rect", "circle")
ATTRIBUTES = ("class", "d", "x", "y", "r", "rx", "cx", "cy", "width", "height", "text-anchor")


@dataclass(frozen=True)
class Shape:
    """An SVG element without children.

    Attributes:
        tag: one of `TAGS`
        attributes: names, each one of `ATTRIBUTES`, and values
        text: of a `text`

    Raises:
        ValueError: another tag or attribute
    """

    tag: str
    attributes: Tuple[Tuple[str, str], ...]
    text: str = ""

    def __post_init__(self) -> None:
        wrong = [name for name, _ in self.attributes if name not in ATTRIBUTES]
        if self.tag not in TAGS or wrong:
            raise ValueError(f"a picture has no {self.tag} with {wrong}")


@dataclass(frozen=True)
class Picture:
    """Shapes on a ground of this size, in pixels; the later ones are on top."""

    width: int
    height: int
    shapes: Tuple[Shape, ...]


def as_svg(picture: Picture, *, style: str = "") -> str:
    """Write a picture as an SVG document."""
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{picture.width}" height="{picture.height}">']
    if style:
        parts.append(f"<style>{escape(style)}</style>")
    for shape in picture.shapes:
        attributes = "".join(f" {name}={quoteattr(value)}" for name, value in shape.attributes)
        parts.append(f"<{shape.tag}{attributes}>{escape(shape.text)}</{shape.tag}>")
    return "\n".join([*parts, "</svg>"]) + "\n"
