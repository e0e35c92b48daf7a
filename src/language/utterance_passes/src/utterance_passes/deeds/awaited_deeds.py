"""Makes a condition of what somebody else is to do: "wait *for Anna to come*" is "wait until Anna comes"."""

from typing import Optional, Tuple

from semantic_types.parts_of_speech import VERB, parts_of_speech
from utterance_passes.engine.pass_needs import only_with_lemmas
from utterance_passes.engine.utterance_pass import Example, Kind, tree_pass
from utterance_passes.trees.tree import ASIDE, DependencyTree, Word
from utterance_passes.trees.tree_edits import TreeEdit
from utterance_passes.trees.vocabulary import Vocabulary
from word_classes import word_class

_WAITING = word_class("verbs_of_waiting")
_PLACES = word_class("here_and_there") | {"right"}
_NO_PHRASE = frozenset(["VERB", "AUX", "PUNCT", "SCONJ"])
#: Words of the phrase for who or what is waited for, at most.
_LONGEST_PHRASE = 6


@tree_pass(
    Kind.MEANING,
    Example(
        "wait|VERB|0|root for|ADP|3|case Bob|PROPN|1|obl to|PART|5|mark come|VERB|1|advcl|come|VB",
        (
            "for: case(Bob) ADP/for for -> mark(come) SCONJ/until until",
            "Bob: obl(wait) -> nsubj(come)",
            "to: mark(come) -> discourse:aside(come)",
        ),
    ),
    assigns=["advcl", "nsubj", "mark", ASIDE],
)
@only_with_lemmas(_WAITING)
def awaited_deeds(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Make a condition of what somebody else is to do: "wait *for Bob to come*".

    "For" becomes "until".
    """
    edit = TreeEdit(tree)
    for verb in tree.words:
        found = _awaited(tree, verb) if verb.lemma.lower() in _WAITING else None
        if found is None:
            continue
        link, border, deed = found
        for word in tree.words[link : border - 1]:
            if not link < word.head < border:
                edit.rehang(word.index, deed.index, "nsubj")
        edit.respell(link, "until")
        edit.retag(link, "SCONJ", "IN")
        edit.rehang(link, deed.index, "mark")
        edit.rehang(border, deed.index, ASIDE)
        edit.tag(deed.index, "VERB", "VBP", "VerbForm=Fin")
        edit.rehang(deed.index, verb.index, "advcl")
    return edit.tree()


def _awaited(tree: DependencyTree, verb: Word) -> Optional[Tuple[int, int, Word]]:
    """Return the positions of "for" and "to" behind a verb of waiting, and the verb behind "to"; None for none."""
    behind = [word for word in tree.words[verb.index :] if word.said not in _PLACES]
    if len(behind) < 4 or behind[0].said != "for":
        return None
    for place, word in enumerate(behind[1 : _LONGEST_PHRASE + 2], start=1):
        if word.upos in _NO_PHRASE:
            return None
        if word.said != "to" or place == 1 or place + 1 >= len(behind):
            continue
        deed = behind[place + 1]
        is_verb = deed.xpos == "VB" or (deed.upos == "NOUN" and VERB in parts_of_speech(deed.said))
        if is_verb and deed.said == deed.lemma.lower():
            return behind[0].index, word.index, deed
    return None
