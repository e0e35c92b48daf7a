"""The files of the page as they are sent: in few requests and bytes, so that it is there soon."""

import base64
import gzip
import hashlib
from dataclasses import dataclass
from pathlib import Path
from typing import Dict, Tuple

FOLDER = Path(__file__).resolve().parent / "page"
_TYPES = {
    ".html": "text/html; charset=utf-8",
    ".css": "text/css; charset=utf-8",
    ".js": "text/javascript; charset=utf-8",
    ".svg": "image/svg+xml",
}
_STYLE_LINK = b'<link rel="stylesheet" href="style.css">'
#: Leaflet draws the map. Debian's package libjs-leaflet has it; without it the page says where the robot is, in words.
LEAFLET = Path("/usr/share/javascript/leaflet")
_LEAFLET_CODE, _LEAFLET_STYLE = "leaflet.esm.min.js", "leaflet.css"


@dataclass(frozen=True)
class PageFile:
    """A file of the page.

    Attributes:
        kind: its media type
        data: its content
        packed: the same, compressed by gzip
    """

    kind: str
    data: bytes
    packed: bytes


def read_page(folder: Path = FOLDER, leaflet: Path = LEAFLET) -> Tuple[Dict[str, PageFile], str]:
    """Read the files of the page by name, and the policy that they need; the page itself has the empty name, too.

    The page holds its style, which a browser would have to ask for before it can draw anything. The policy allows
    this text as a style, and no other.
    """
    data = {path.name: path.read_bytes() for path in folder.iterdir() if path.suffix in _TYPES}
    style = data["style.css"]
    if (leaflet / _LEAFLET_CODE).is_file():
        data["leaflet.js"] = (leaflet / _LEAFLET_CODE).read_bytes()
        style = (leaflet / _LEAFLET_STYLE).read_bytes() + style
    assert data["index.html"].count(_STYLE_LINK) == 1
    data["index.html"] = data["index.html"].replace(_STYLE_LINK, b"<style>" + style + b"</style>")
    digest = base64.b64encode(hashlib.sha256(style).digest()).decode("ascii")
    files = {name: _file(_TYPES[Path(name).suffix], content) for name, content in data.items()}
    files[""] = files["index.html"]
    return files, (
        f"default-src 'self'; style-src 'sha256-{digest}'; base-uri 'none'; form-action 'none'; "
        "frame-ancestors 'none'; object-src 'none'"
    )


def _file(kind: str, data: bytes) -> PageFile:
    return PageFile(kind, data, gzip.compress(data, mtime=0))
