"""Tells apart who is told or asked something, and what: a parser attaches a message to the description of a person."""

from utterance_passes.engine.utterance_pass import Example, Kind, tree_pass
from utterance_passes.trees.persons import is_person_or_name
from utterance_passes.trees.tree import DependencyTree
from utterance_passes.trees.tree_edits import TreeEdit
from utterance_passes.trees.vocabulary import Speech, Verbs, Vocabulary
from word_classes import word_class

_INFORMING = word_class("saying_verbs")


@tree_pass(
    Kind.MEANING,
    Example(
        "tell|VERB|0|root Bob|PROPN|1|obj",
        ("Bob: obj(tell) -> iobj(tell)",),
        Verbs(frozenset(["tell"]), speech={"tell": Speech.TOLD}),
    ),
    requires=["obj", "iobj"],
    assigns=["iobj", "obl"],
)
def persons_told(tree: DependencyTree, vocabulary: Vocabulary) -> DependencyTree:
    """Make a person the hearer who is the only object of a verb of telling: "tell *the man raising his hand*". What a
    person is told about belongs to the verb: "warn the guests *about the dog*"."""
    edit = TreeEdit(tree)
    for topic in tree.words:
        hearer = tree.governor(topic)
        is_about = topic.deprel == "nmod" and "about" in tree.said_prepositions(topic.index)
        is_told = hearer.deprel in ("obj", "iobj") and tree.governor(hearer).lemma.lower() in _INFORMING
        if is_about and is_told and is_person_or_name(hearer):
            edit.rehang(topic.index, hearer.head, "obl")
    for verb in tree.words:
        if vocabulary.speech_of(verb.lemma.lower()) is not Speech.TOLD or verb.upos != "VERB":
            continue
        children = tree.children(verb.index)
        objects = [child for child in children if child.deprel in ("obj", "iobj", "ccomp", "xcomp")]
        is_alone = len(objects) == 1 and tree.phrase_start(objects[0].index) == verb.index + 1
        if is_alone and objects[0].deprel == "obj" and is_person_or_name(objects[0]):
            edit.relabel(objects[0].index, "iobj")
    return edit.tree()
