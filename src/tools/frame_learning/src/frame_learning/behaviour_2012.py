"""Understands sentences as in 2012, with the trees and units of today, for comparison.

Thomas and Jenkins, ICRA 2012: a lexical unit whose verb is in the sentence looks for single words in grammatical
relations to it, and counts when all core elements of its frame are filled. Every other word is ignored: phrases,
negations, conditions, prepositional phrases attached elsewhere.
"""

from typing import List, Mapping, Tuple

from frame_learning.corpus_mapping import CorpusMapping
from semantic_framer.units.lexicon import Lexicon
from semantic_framer.units.type_fits import fit_of_relation
from semantic_framer.values.sentence import Sentence
from semantic_frames.frame import SemanticFrame
from semantic_frames.lexical_unit import ElementRelation, LexicalUnit
from semantic_frames.relation_names import MEASURE
from semantic_types import Fit
from utterance_passes.engine.running import run_tree_passes
from utterance_passes.table import PARSE_CORRECTING_PASSES
from utterance_passes.trees.tree import VERBS, DependencyTree
from utterance_passes.trees.vocabulary import Verbs

#: A frame with the position of its verb, and the position of the word that fills each element.
Filled = Tuple[SemanticFrame, int, Tuple[Tuple[str, int], ...]]


def understand_2012(
    tree: DependencyTree, lexicon: Lexicon, frames: Mapping[str, SemanticFrame], mapping: CorpusMapping
) -> Tuple[Filled, ...]:
    """Fill lexical units as in 2012.

    Args:
        tree: the parse of a sentence
        lexicon: lexical units; a particle of a verb must directly follow the verb
        frames: by name
        mapping: says which frames are the same in the corpus
    Returns:
        for each verb the units that fill the most elements, one for each frame of the corpus
    """
    sentence = Sentence(run_tree_passes(tree, Verbs(), PARSE_CORRECTING_PASSES))
    filled: List[Filled] = []
    for word in tree.words:
        if word.upos not in VERBS:
            continue
        found: List[Filled] = []
        for verb in lexicon.verbs_beginning_with(word.lemma.lower()):
            particles = [other.said for other in tree.words[word.index : word.index + len(verb.split()) - 1]]
            if particles != verb.split()[1:]:
                continue
            for unit in lexicon.units_of(verb, frames):
                frame = frames.get(unit.frame_name)
                values = _values(sentence, word.index, unit) if frame is not None else ()
                names = {name for name, _ in values}
                if frame is not None and all(
                    element.name in names or element.default or not element.is_core for element in frame.frame_elements
                ):
                    found.append((frame, word.index, values))
        most = max((len(values) for _, _, values in found), default=0)
        best = {mapping.frame_name(item[0]): item for item in reversed(found) if len(item[2]) == most}
        filled += list(best.values())
    return tuple(filled)


def _values(sentence: Sentence, verb: int, unit: LexicalUnit) -> Tuple[Tuple[str, int], ...]:
    values = []
    for relation in unit.relations:
        position = next(
            (
                position
                for path in relation.relations
                for position in _follow(sentence, verb, path.steps)
                if _is_allowed(sentence, position, relation)
            ),
            0,
        )
        if position:
            values.append((relation.name, position))
    return tuple(values)


def _is_allowed(sentence: Sentence, position: int, relation: ElementRelation) -> bool:
    word = sentence.word(position)
    is_listed = word.said in relation.words or word.lemma.lower() in relation.words
    return is_listed or fit_of_relation(sentence.types, position, relation) is not Fit.WRONG


def _follow(sentence: Sentence, verb: int, steps: Tuple[str, ...]) -> List[int]:
    governors = [verb]
    for step in steps:
        # In 2012 a number was a modifier of the word that it counts.
        if step == MEASURE:
            objects = [
                position
                for relation in ("dobj", "tmod", "npadvmod")
                for governor in governors
                for position in sentence.dependents(governor, relation)
            ]
            governors = [number for position in objects for number in sentence.dependents(position, "num")]
        else:
            governors = [position for governor in governors for position in sentence.dependents(governor, step)]
    return governors
