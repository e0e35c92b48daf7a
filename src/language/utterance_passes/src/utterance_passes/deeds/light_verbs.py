"""Replaces light verbs: "can I have the mug" means "I want the mug", and "do a u-turn" means "make a u-turn"."""

from utterance_passes.engine.pass_needs import only_with_lemmas
from utterance_passes.engine.utterance_pass import Example, Kind, tree_pass
from utterance_passes.trees.persons import is_likely
from utterance_passes.trees.tree import DependencyTree, Word
from utterance_passes.trees.tree_edits import TreeEdit
from utterance_passes.trees.vocabulary import Verbs, Vocabulary
from word_classes import word_class

_WISH = "want"
_MAKE, _WASH = "make", "wash"
#: "Can I have ...", "could we get ...".
_ASKED_FOR = frozenset(["have", "get"])
_PERMISSION_MODALS = word_class("polite_modals") - word_class("future_auxiliaries")
#: "I would love ..." is a wish; without "would", the verb says what somebody likes.
_WISHING_VERBS = word_class("wishing_verbs")
_WOULD = frozenset(["would", "'d", "’d"])
_SPEAKERS = word_class("speaker_subjects")


@tree_pass(
    Kind.MEANING,
    Example(
        "can|AUX|3|aux I|PRON|3|nsubj have|VERB|0|root tea|NOUN|3|obj",
        ("have: VERB/have have -> VERB/want want",),
        Verbs(frozenset(["want"])),
    ),
)
@only_with_lemmas(_ASKED_FOR | _WISHING_VERBS | {"do"})
def light_verbs(tree: DependencyTree, vocabulary: Vocabulary) -> DependencyTree:
    """Replace light verbs by the verbs that they mean, if the lexicon has those: "can I have" means "I want".

    The lexicon itself has no verb "do": the parser would take the "do" in "don't" for the command.
    """
    edit = TreeEdit(tree)
    for word in tree.words:
        lemma = word.lemma.lower()
        if lemma == "do" and word.upos == "VERB":
            meant = _verb_of_done(tree, word, vocabulary)
            if meant:
                edit.respell(word.index, meant)
        elif (
            lemma in _ASKED_FOR | _WISHING_VERBS
            and _WISH in vocabulary.verbs_beginning_with(_WISH)
            and _is_wish(tree, word)
        ):
            edit.respell(word.index, _WISH)
    return edit.tree()


def _verb_of_done(tree: DependencyTree, word: Word, vocabulary: Vocabulary) -> str:
    """Return the verb for what is done: "make" for a u-turn, "wash" for the dishes; empty if there is none."""
    things = [child for child in tree.children(word.index) if child.deprel == "obj"]
    done = frozenset(child.said for child in things)
    made = frozenset(verb.partition(" ")[2] for verb in vocabulary.verbs_beginning_with(_MAKE))
    if not done.isdisjoint(made.union(*vocabulary.lists_of(_MAKE))):
        return _MAKE
    # "Do the laundry", "do the dishes", but not "do the mug".
    is_washed = any(
        is_likely(thing, ["Clothing"]) or (thing.xpos == "NNS" and is_likely(thing, ["Container"])) for thing in things
    )
    is_washed = is_washed and _WASH in vocabulary.verbs_beginning_with(_WASH)
    return _WASH if is_washed else ""


def _is_wish(tree: DependencyTree, word: Word) -> bool:
    children = tree.children(word.index)
    modals = _WOULD if word.lemma.lower() in _WISHING_VERBS else _PERMISSION_MODALS
    is_for_another = any(child.said == "you" for child in children)
    return (
        any(child.deprel == "aux" and child.said in modals for child in children)
        and any(child.deprel == "nsubj" and child.said in _SPEAKERS for child in children)
        and any(child.deprel == "obj" for child in children)
        and not is_for_another
    )
