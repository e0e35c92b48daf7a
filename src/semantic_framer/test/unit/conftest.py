"""One parser and the frames of the domains, for all tests of the framer."""

from pathlib import Path
from typing import Callable, Dict, Tuple

import pytest

from checked_files.source_files import FRAMES_FOLDER, LEXICAL_UNITS_FOLDER, yaml_files
from roboframenet_testing.workspace import package
from semantic_framer.framer import Outcome, Policy, read
from semantic_framer.units.lexicon import Lexicon
from semantic_framer.values.dialogue import Context
from semantic_framer.values.outcome import MEANING_ONLY
from semantic_frames import load_frame
from semantic_frames.frame import SemanticFrame
from stanford_parser_ros.model import Parser, shipped_parser

DOMAINS = package("roboframenet_domains") / "domains"

Understand = Callable[..., Tuple[Outcome, Context]]


@pytest.fixture(scope="session")
def lexicon() -> Lexicon:
    lexicon = Lexicon()
    for path in yaml_files([str(DOMAINS)], LEXICAL_UNITS_FOLDER):
        lexicon.add_file(Path(path).read_text(encoding="utf-8"), path)
    return lexicon


@pytest.fixture(scope="session")
def frames() -> Dict[str, SemanticFrame]:
    loaded = [
        load_frame(Path(path).read_text(encoding="utf-8"), path) for path in yaml_files([str(DOMAINS)], FRAMES_FOLDER)
    ]
    return {frame.name: frame for frame in loaded}


@pytest.fixture(scope="session")
def parser() -> Parser:
    return shipped_parser()


@pytest.fixture(scope="session")
def understand(parser: Parser, lexicon: Lexicon, frames: Dict[str, SemanticFrame]) -> Understand:
    verbs = frozenset(verb.split()[0] for verb in lexicon.verbs)

    def call(
        text: str, context: Context = Context(), policy: Policy = MEANING_ONLY, now_s: float = 0.0
    ) -> Tuple[Outcome, Context]:
        return read(parser.parse(text, verbs), lexicon, frames, context=context, policy=policy, now_s=now_s)

    return call
