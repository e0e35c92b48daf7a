"""Reads the file that maps WordNet's synsets, and words that WordNet lacks, to semantic types."""

from dataclasses import dataclass, field
from typing import Dict, List, Mapping, Optional, Tuple

import yaml

from checked_files.marked_yaml import Reader, describe
from semantic_frames.semantic_type import read_semantic_type, read_semantic_types
from semantic_types.wordnet import WordNet

FILE_KEYS = ("synsets", "kinds", "words")
SYNSET_KEYS = ("synset", "because")
KIND_KEYS = ("synset", "is_also", "because")
WORD_KEYS = ("types", "because")


@dataclass(frozen=True)
class NounFile:
    """The content of the file.

    Attributes:
        synsets: types of a synset and of everything below it that has no entry of its own
        words: types of words, in the order of likelihood; they replace what WordNet says
        kinds: synsets of which a synset is a kind, beside those that WordNet says
    """

    synsets: Mapping[int, Tuple[str, ...]]
    words: Mapping[str, Tuple[str, ...]]
    kinds: Mapping[int, Tuple[int, ...]] = field(default_factory=dict)


def load_noun_file(text: str, path: str, wordnet: WordNet) -> NounFile:
    """Read a file of synsets and words.

    Args:
        text: content of the file
        path: where it came from, for problems
        wordnet: knows the synsets
    Raises:
        FileRefused: the file has mistakes; the exception carries all of them
    """
    reader = Reader(path)
    root = reader.mapping(reader.compose(text, "a mapping with synsets"), "", FILE_KEYS, required=("synsets",))
    synsets = _synsets(reader, root.get("synsets"), wordnet)
    kinds = _kinds(reader, root.get("kinds"), wordnet)
    words: Dict[str, Tuple[str, ...]] = {}
    for name_node, node in reader.free_mapping(root.get("words"), "words"):
        word = " ".join(reader.name(name_node, "words").lower().split())
        key = f"words.{word}"
        entry = reader.mapping(node, key, WORD_KEYS, required=WORD_KEYS)
        if word in words:
            reader.report("DUPLICATE_WORD", name_node, key, f"a second '{word}'", "each word once")
        words[word] = read_semantic_types(reader, entry.get("types"), f"{key}.types")
    reader.refuse_if_wrong()
    return NounFile({synset: tuple(types) for synset, types in synsets.items()}, words, kinds)


def _synsets(reader: Reader, node: Optional[yaml.Node], wordnet: WordNet) -> Mapping[int, List[str]]:
    found: Dict[int, List[str]] = {}
    for type_node, list_node in reader.free_mapping(node, "synsets"):
        name = read_semantic_type(reader, type_node, f"synsets.{describe(type_node)}")
        for key, item in reader.sequence(list_node, f"synsets.{name}"):
            is_explained = isinstance(item, yaml.MappingNode)
            entry = reader.mapping(item, key, SYNSET_KEYS, required=SYNSET_KEYS) if is_explained else {"synset": item}
            synset = _synset(reader, entry.get("synset"), key, wordnet)
            if synset is None:
                continue
            if name in found.setdefault(synset, []):
                found_again = f"a second '{describe(entry['synset'])}'"
                reader.report("DUPLICATE_SYNSET", item, key, found_again, "each synset once")
            found[synset].append(name)
    return found


def _kinds(reader: Reader, node: Optional[yaml.Node], wordnet: WordNet) -> Mapping[int, Tuple[int, ...]]:
    found: Dict[int, Tuple[int, ...]] = {}
    for key, item in reader.sequence(node, "kinds"):
        entry = reader.mapping(item, key, KIND_KEYS, required=KIND_KEYS)
        synset = _synset(reader, entry.get("synset"), key, wordnet)
        above = _synset(reader, entry.get("is_also"), key, wordnet)
        if synset is not None and above is not None:
            found[synset] = (*found.get(synset, ()), above)
    return found


def _synset(reader: Reader, node: Optional[yaml.Node], key: str, wordnet: WordNet) -> Optional[int]:
    if node is None:
        return None  # The missing key is reported.
    name = reader.name(node, key)
    synset = wordnet.synset(name)
    if synset is None:
        expected = "a synset of WordNet such as person.n.01, the first sense of 'person'"
        reader.report("UNKNOWN_SYNSET", node, key, f"'{name}'", expected)
    return synset
