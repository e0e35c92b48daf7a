"""What is only said around a command: "I was wondering if you could ...", "if you don't mind", "right away".

Such formulas are no wishes, conditions or negations of their own. Their words become *asides* of the sentence, which
nothing that is read later looks at.
"""

import re
from dataclasses import replace
from typing import AbstractSet, FrozenSet, List

from stanford_parser_ros.imperative import LEAD_IN
from stanford_parser_ros.surroundings import is_opening
from stanford_parser_ros.tree import DependencyTree, Word

from semantic_framer.clauses import NEGATIONS
from semantic_framer.lexicon import Lexicon
from semantic_framer.sentence import ASIDE, HEDGES, QUOTED

_NOT = "(n't|not|nt)"
#: What may stand in front of a command, behind it, or between commas.
_ANYWHERE = re.compile(
    "|".join(
        [
            f"if (you|that|it) (do|does|would) {_NOT} mind( that)?",
            "as (soon|quickly|fast) as (you (can|could)|possible)",
            "right now|right away|straight away|at once|immediately",
            "(when|whenever|if) you (get|have|find|'ve got) (a |some |the )?(chance|moment|minute|second|sec|time)",
            "if (it|that) (is|'s) (ok|okay|alright|fine|not too much (trouble|to ask))( with you)?",
        ]
    )
)
#: The same, but not right in front of a verb: "if you can open the door" is a condition.
_APART = re.compile("if you (can|could|please|would|will|like|may|want)|if (it 's )?(possible|ok|okay)( with you)?")
#: What may only end a command.
_ENDINGS = re.compile(
    "|".join(
        [
            "(would|will|could|can|wo n't|ca n't) you( please)?",
            "(many )?(thank you|thanks)( (very|so) much| a lot| in advance)?",
            "by the way|i think|i guess|i suppose|you know",
            "or something( like that)?",
        ]
    )
)
#: No formula has more words.
_LONGEST = 12
#: What may stand between a formula and the verb.
_LEADING = LEAD_IN | HEDGES


def with_opening_aside(tree: DependencyTree, lexicon: Lexicon) -> DependencyTree:
    """Set the formula aside that a command is opened with: "I was wondering if you could ...".

    Args:
        tree: the sentence
        lexicon: its verbs tell where the command begins
    Returns:
        the sentence, with the same words in the same places
    """
    positions = _opening(tree, lexicon)
    return set_aside(tree, positions, lexicon, ASIDE) if positions else tree


def with_asides(tree: DependencyTree, lexicon: Lexicon) -> DependencyTree:
    """Set the formulas aside that a command is surrounded with: "... right away, if you don't mind"; those in a
    quotation belong to it.
    """
    while True:
        positions = _around(tree, lexicon)
        if not positions:
            return tree
        tree = set_aside(tree, positions, lexicon, ASIDE)


def _open_words(tree: DependencyTree) -> List[Word]:
    """Words that are no asides yet, nor corrected, nor quoted."""
    return [word for word in tree.words if word.deprel not in (ASIDE, QUOTED, "reparandum")]


def _opening(tree: DependencyTree, lexicon: Lexicon) -> FrozenSet[int]:
    words = _open_words(tree)
    first = _behind_lead_in(words, 0)
    for behind in range(min(len(words) - 1, first + _LONGEST), first, -1):
        said = words[first:behind]
        if said[-1].upos == "PUNCT" or not is_opening([word.form for word in said]):
            continue
        following = _behind_lead_in(words, behind)
        # "... if you could not turn left" negates as ever.
        following += following < len(words) - 1 and words[following].form.lower() in NEGATIONS
        if following < len(words) and _is_verb(words[following], lexicon):
            return frozenset(word.index for word in said)
    return frozenset()


def _behind_lead_in(words: List[Word], position: int) -> int:
    while position < len(words) and (
        words[position].upos in ("PUNCT", "INTJ") or words[position].form.lower() in _LEADING
    ):
        position += 1
    return position


def _around(tree: DependencyTree, lexicon: Lexicon) -> FrozenSet[int]:
    words = _open_words(tree)
    spoken = [word for word in words if word.upos != "PUNCT"]
    for first, word in enumerate(words):
        for behind in range(min(len(words), first + _LONGEST), first, -1):
            said = words[first:behind]
            if word.upos == "PUNCT" or said[-1].upos == "PUNCT" or len(said) == len(spoken):
                continue
            is_apart = behind == len(words) or words[behind].upos == "PUNCT"
            is_front = word.index == spoken[0].index
            text = _text(said)
            if (
                (is_apart and _APART.fullmatch(text))
                or (is_apart and not is_front and _ENDINGS.fullmatch(text))
                or ((is_apart or is_front and _is_verb(words[behind], lexicon)) and _ANYWHERE.fullmatch(text))
            ) and not (first and _belongs_to(words[first - 1], word, lexicon)):
                return frozenset(word.index for word in said)
    return frozenset()


def _belongs_to(before: Word, word: Word, lexicon: Lexicon) -> bool:
    """Whether a word belongs to the one in front of it: "to the right now", "turn right now"."""
    verbs = lexicon.verbs_beginning_with(before.lemma.lower()) if before.upos == "VERB" else ()
    units = [unit for verb in verbs for unit in lexicon.units_of(verb)]
    return before.upos in ("ADP", "DET", "SCONJ") or any(
        word.form.lower() in relation.words for unit in units for relation in unit.relations
    )


def _text(words: List[Word]) -> str:
    return " ".join(word.form.lower().replace("’", "'") for word in words)


def _is_verb(word: Word, lexicon: Lexicon) -> bool:
    return any(lexicon.verbs_beginning_with(spelling) for spelling in (word.form.lower(), word.lemma.lower()))


def set_aside(tree: DependencyTree, positions: AbstractSet[int], lexicon: Lexicon, relation: str) -> DependencyTree:
    """Hang words on the root of the others, and what hung on them where they hung.

    Args:
        tree: the sentence
        positions: of the words; at least one word is left
        lexicon: one of its verbs becomes the root where the root was one of the words
        relation: of each of the words to the root
    """
    heads = {}
    for word in tree.words:
        head = word.head
        while head in positions:
            head = tree.word(head).head
        heads[word.index] = head
    tops = [word for word in _open_words(tree) if word.index not in positions and heads[word.index] == 0]
    spoken = [word for word in tops if word.upos != "PUNCT"]
    root = ([word for word in spoken if _is_verb(word, lexicon)] or spoken or tops)[0]
    words = []
    for word in tree.words:
        if word.index == root.index:
            words.append(replace(word, head=0, deprel="root"))
        elif word.index in positions:
            words.append(replace(word, head=root.index, deprel=relation))
        elif heads[word.index] == 0:
            is_clause = word.upos == "VERB" and word.index > root.index
            words.append(replace(word, head=root.index, deprel="parataxis" if is_clause else word.deprel))
        else:
            words.append(replace(word, head=heads[word.index]))
    return replace(tree, words=tuple(words))
