"""The folder of words: networks, their vocabularies and dictionaries."""

import json
from pathlib import Path
from typing import Any, Dict, List, Mapping, NamedTuple

from stanford_parser_ros import checked_folder

ENDS, CUTS, LEMMA, WORDS = "ends.onnx", "cuts.onnx", "lemma.onnx", "words.json"
FILES = (ENDS, CUTS, LEMMA, WORDS)
#: What stands for a unit that a network has not learned.
UNKNOWN = 1


class WordFiles(NamedTuple):
    """What the folder holds, of a Stanza package.

    Attributes:
        package: name of it
        longest_token: characters of a token that the tokenizer takes
        text_characters, token_characters, letters, parts_of_speech: number of each unit, for the four inputs
        expansions: words of a multi-word token, with a space between them
        lemmas: of each form, by part of speech; "*" for all
    """

    package: str
    longest_token: int
    text_characters: Dict[str, int]
    token_characters: Dict[str, int]
    letters: Dict[str, int]
    parts_of_speech: Dict[str, int]
    expansions: Mapping[str, str]
    lemmas: Mapping[str, Mapping[str, str]]


def read_word_folder(folder: Path) -> WordFiles:
    """Read the folder.

    Raises:
        ModelError: a file is missing, or is not the one that was packed
    """
    content = json.loads(checked_folder.read_checked(folder, FILES)[WORDS])
    numbered = ("text_characters", "token_characters", "letters", "parts_of_speech")
    return WordFiles(**{**content, **{name: _numbers(content[name]) for name in numbered}})


def _numbers(units: List[Any]) -> Dict[str, int]:
    return {unit: number for number, unit in enumerate(units)}


def write_manifest(folder: Path) -> None:
    """Write the sums of the files of a folder."""
    checked_folder.write_manifest(folder, FILES)
