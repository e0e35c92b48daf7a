"""Finds the verb of a command at its front by the lexicon, and makes it the root."""

from typing import Optional, Sequence

from utterance_passes.tree import DependencyTree
from utterance_passes.tree_edits import TreeEdit
from utterance_passes.utterance_pass import Example, Kind, tree_pass
from utterance_passes.vocabulary import Verbs, Vocabulary
from word_classes import word_class

_AUXILIARIES = word_class("forms_of_have") | word_class("forms_of_do")
_FORMS_OF_BE = word_class("forms_of_be")
_PERSONS = word_class("personal_subjects")
_LEAD_IN = word_class("lead_in")
_NOUNS = {"NOUN", "PROPN", "PRON", "NUM", "ADJ", "DET"}
#: Relations of words that belong to the verb of the command, not to the word that the parser took for it.
_OF_THE_VERB = frozenset(["punct", "obl", "advmod", "discourse", "vocative", "conj", "parataxis"])


def command_verb_position(forms: Sequence[str], vocabulary: Vocabulary) -> Optional[int]:
    """Find the word that must be the verb of a command: the first one after the addressee, politeness and fillers.

    Args:
        forms: words of the sentence
        vocabulary: known verbs
    Returns:
        its index from 1; None if the front of the sentence has no known verb
    """
    position = 0
    while position < len(forms) and (forms[position].lower() in _LEAD_IN or forms[position] == ","):
        position += 1
    if position < len(forms) and vocabulary.verbs_beginning_with(forms[position].lower()):
        # "Name is Bob": a noun before a finite verb is not a command.
        following = forms[position + 1].lower() if position + 1 < len(forms) else ""
        # "Have you been there" is a question.
        is_auxiliary = forms[position].lower() in _AUXILIARIES and following in _PERSONS
        return None if following in _FORMS_OF_BE or is_auxiliary else position + 1
    return None


@tree_pass(
    Kind.REPAIR,
    Example(
        "Scrub|VERB|3|compound the|DET|3|det pot|NOUN|0|root",
        ("Scrub: compound(pot) -> root", "pot: root -> obj(Scrub)"),
        Verbs(frozenset(["scrub"])),
    ),
)
def reroot(tree: DependencyTree, vocabulary: Vocabulary) -> DependencyTree:
    """Make the verb of the command the root, and attach the old root and the phrases of the command to it."""
    index = command_verb_position([word.form for word in tree.words], vocabulary)
    if index is None or tree.word(index).head == 0:
        return tree
    old_root = tree.children(0)[0]
    edit = TreeEdit(tree)
    for word in tree.children(old_root.index):
        if word.deprel.split(":")[0] in _OF_THE_VERB:
            edit.rehang(word.index, index)
    edit.rehang(old_root.index, index, "obj" if old_root.upos in _NOUNS else "xcomp")
    edit.rehang(index, 0, "root")
    edit.drop_brackets()
    return edit.tree()
