"""What is only said around a command: "I was wondering if you could ...", "if you don't mind", "right away".

Such formulas are no wishes, conditions or negations of their own. Their words become *asides* of the sentence, which
nothing that is read later looks at.
"""

import re
from typing import FrozenSet, Sequence

from utterance_passes.tree import ASIDE, DependencyTree, Word
from utterance_passes.tree_edits import set_aside
from utterance_passes.vocabulary import Vocabulary, is_verb
from utterance_passes.word_classes import HEDGES, LEAD_IN, NEGATIONS

_NOT = "(n't|not|nt)"
_COULD = "(could|can|would|will|might)"
#: What may lead to a command; a verb of the lexicon must follow.
_OPENINGS = re.compile(
    "|".join(
        [
            f"why do {_NOT} (you|we)",
            "(how|what) about (if )?(you|we)",
            f"i (was|am|'m) (just )?wondering (if|whether) you {_COULD}",
            f"i wonder (if|whether) you {_COULD}",
            f"do you think (that )?you {_COULD}",
            "i (think|guess|suppose|believe) (that )?(you|we) (should|could|can|might|must)",
            "(i think )?(you|we) (had better|'d better|ought to)",
            "(is it|would it be|will it be) (possible|ok|okay|fine|alright) (for you )?to",
            f"(is it|would it be) (possible|ok|okay) if you {_COULD}",
            f"it (would|'d) be (really |very |so )?(great|nice|good|lovely|kind|helpful) if you {_COULD}",
            f"i (would|'d) (really )?(appreciate|like|love) it if you {_COULD}",
            "i (would|'d) be (really |very |so )?(grateful|happy|glad) if you (could|would)",
            "(could|can|may|might) i (ask|get|trouble|bother) you to",
            "do (me|us) (a|the) (big |little |small |quick )?(favor|favour)( and)?",
            "be (a|an) (good )?(dear|darling|angel|sweetheart|sport|pal|star|robot) and",
            "(would you |could you )?(please )?be (so |very )?(kind|good|nice) (enough )?(as )?(to|and)",
            "(would you |could you )?(please )?(make|be) sure (to|and|that you|you)",
            f"(please )?do {_NOT} forget to",
            "(are|would|will|might) you (be )?able to",
            "(is there )?any chance (that )?you (could|can)",
            "go ahead and",
            "quick",
            "hurry( up)?( and)?",
            "help (me|us)( to)?",
            "let 's",
            "you know what",
            "excuse me( but)?",
        ]
    )
)
#: What may stand in front of a command, behind it, or between commas.
_ANYWHERE = re.compile(
    "|".join(
        [
            f"if (you|that|it) (do|does|would) {_NOT} mind( that)?",
            "as (soon|quickly|fast) as (you (can|could)|possible)",
            "right now|right away|straight away|at once|immediately",
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


def without_opening(tree: DependencyTree, vocabulary: Vocabulary) -> DependencyTree:
    """Set the formula aside that a command is opened with: "I was wondering if you could ..."."""
    positions = _opening(tree, vocabulary)
    return set_aside(tree, positions, ASIDE, lambda word: is_verb(vocabulary, word)) if positions else tree


def without_formulas(tree: DependencyTree, vocabulary: Vocabulary) -> DependencyTree:
    """Set the formulas aside that a command is surrounded with: "... right away, if you don't mind"; those in a
    quotation belong to it.
    """
    while True:
        positions = _around(tree, vocabulary)
        if not positions:
            return tree
        tree = set_aside(tree, positions, ASIDE, lambda word: is_verb(vocabulary, word))


def _opening(tree: DependencyTree, vocabulary: Vocabulary) -> FrozenSet[int]:
    words = tree.open_words
    first = _behind_lead_in(words, 0)
    for behind in range(min(len(words) - 1, first + _LONGEST), first, -1):
        said = words[first:behind]
        if said[-1].upos == "PUNCT" or not _OPENINGS.fullmatch(_text(said)):
            continue
        following = _behind_lead_in(words, behind)
        # "... if you could not turn left" negates as ever.
        following += following < len(words) - 1 and words[following].form.lower() in NEGATIONS
        if following < len(words) and is_verb(vocabulary, words[following]):
            return frozenset(word.index for word in said)
    return frozenset()


def _behind_lead_in(words: Sequence[Word], position: int) -> int:
    while position < len(words) and (
        words[position].upos in ("PUNCT", "INTJ") or words[position].form.lower() in _LEADING
    ):
        position += 1
    return position


def _around(tree: DependencyTree, vocabulary: Vocabulary) -> FrozenSet[int]:
    words = tree.open_words
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
                or ((is_apart or is_front and is_verb(vocabulary, words[behind])) and _ANYWHERE.fullmatch(text))
            ) and not (first and _belongs_to(words[first - 1], word, vocabulary)):
                return frozenset(word.index for word in said)
    return frozenset()


def _belongs_to(before: Word, word: Word, vocabulary: Vocabulary) -> bool:
    """Whether a word belongs to the one in front of it: "to the right now", "turn right now"."""
    verbs = vocabulary.verbs_beginning_with(before.lemma.lower()) if before.upos == "VERB" else ()
    return before.upos in ("ADP", "DET", "SCONJ") or any(
        word.form.lower() in listed for verb in verbs for listed in vocabulary.lists_of(verb)
    )


def _text(words: Sequence[Word]) -> str:
    return " ".join(word.form.lower().replace("’", "'") for word in words)
