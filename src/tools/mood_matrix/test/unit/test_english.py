"""The small grammar of English: forms of verbs, noun phrases, predicates."""

import pytest

from mood_matrix.english import (
    NounPhrase,
    Predicate,
    gerund_of,
    participle_of,
    past_of,
    plural_of,
    sentence,
    third_of,
)

CLOSE = Predicate("close", object="the door")
POUR = Predicate("pour", receiver="me", object="a beer", rest="into the glass")
SWITCH = Predicate("turn", "on", object="the light")


@pytest.mark.parametrize(
    "verb, third, past, participle, gerund",
    [
        ("close", "closes", "closed", "closed", "closing"),
        ("pass", "passes", "passed", "passed", "passing"),
        ("fix", "fixes", "fixed", "fixed", "fixing"),
        ("carry", "carries", "carried", "carried", "carrying"),
        ("play", "plays", "played", "played", "playing"),
        ("mix", "mixes", "mixed", "mixed", "mixing"),
        ("free", "frees", "freed", "freed", "freeing"),
        ("go", "goes", "went", "gone", "going"),
        ("have", "has", "had", "had", "having"),
        ("take", "takes", "took", "taken", "taking"),
        ("lie", "lies", "lay", "lain", "lying"),
        ("lay", "lays", "laid", "laid", "laying"),
        ("hang", "hangs", "hung", "hung", "hanging"),
        ("undo", "undoes", "undid", "undone", "undoing"),
        ("catch", "catches", "caught", "caught", "catching"),
        ("sweep", "sweeps", "swept", "swept", "sweeping"),
    ],
)
def test_a_verb_is_inflected(verb: str, third: str, past: str, participle: str, gerund: str) -> None:
    assert (third_of(verb), past_of(verb), participle_of(verb), gerund_of(verb)) == (third, past, participle, gerund)


@pytest.mark.parametrize("verb", ["stop", "chop", "nod", "grab", "unplug", "patrol", "shut", "quit", "hug", "drop"])
def test_a_short_stressed_syllable_doubles_its_last_letter(verb: str) -> None:
    assert gerund_of(verb) == f"{verb}{verb[-1]}ing"


@pytest.mark.parametrize("verb", ["open", "offer", "deliver", "fix", "show", "wait", "pour", "empty", "lift", "peel"])
def test_other_verbs_double_nothing(verb: str) -> None:
    assert gerund_of(verb) == f"{verb}ing"


@pytest.mark.parametrize(
    "noun, plural",
    [
        ("door", "doors"),
        ("box", "boxes"),
        ("lobby", "lobbies"),
        ("key", "keys"),
        ("shelf", "shelves"),
        ("man", "men"),
        ("tomato", "tomatoes"),
    ],
)
def test_a_noun_has_a_plural(noun: str, plural: str) -> None:
    assert plural_of(noun) == plural


def test_a_noun_phrase_has_a_head_and_what_belongs_to_it() -> None:
    vase = NounPhrase("the vase on the floor")
    assert (vase.determiner, vase.core, vase.head, vase.is_whole) == ("the", "vase", "vase", False)
    assert NounPhrase("the washing machine").head == "machine"
    assert NounPhrase("the two boxes").kind == "boxes"
    assert NounPhrase("some soup").kind == "soup"
    assert NounPhrase("Anna").kind == "people"
    assert NounPhrase("Anna").definite == "the person"
    assert NounPhrase("my glasses").definite == "the glasses"


@pytest.mark.parametrize(
    "text, is_plural",
    [("the dishes", True), ("the glass", False), ("my glasses", True), ("the people", True), ("Mr Jones", False)],
)
def test_a_noun_phrase_is_plural(text: str, is_plural: bool) -> None:
    assert NounPhrase(text).is_plural is is_plural


def test_a_predicate_is_said_in_every_form() -> None:
    assert CLOSE.base() == "close the door"
    assert CLOSE.third() == "closes the door"
    assert POUR.past() == "poured me a beer into the glass"
    assert SWITCH.participle() == "turned on the light"
    assert SWITCH.gerund() == "turning on the light"


def test_the_object_is_left_out_of_questions_and_relative_clauses() -> None:
    assert POUR.base(gap="object") == "pour me into the glass"
    assert SWITCH.past(gap="object") == "turned on"


def test_the_passive_has_the_object_for_its_subject() -> None:
    assert (CLOSE.passive_subject, CLOSE.passive("closed")) == ("the door", "closed")
    assert (SWITCH.passive_subject, SWITCH.passive("turned")) == ("the light", "turned on")
    assert (POUR.passive_subject, POUR.passive("poured")) == ("a beer", "poured for me into the glass")
    give = Predicate("give", receiver="the guest", object="the mug")
    assert (give.passive_subject, give.passive("given")) == ("the mug", "given to the guest")


def test_who_is_asked_something_is_the_subject_of_the_passive() -> None:
    ask = Predicate("ask", receiver="Bob", object="a question")
    assert (ask.passive_subject, ask.passive("asked")) == ("Bob", "asked a question")


@pytest.mark.parametrize(
    "predicate",
    [
        Predicate("wait"),
        Predicate("hug", object="me"),
        Predicate("tell", receiver="me", object="the time"),
        Predicate("go", "down", object="the hallway"),
    ],
)
def test_some_predicates_have_no_passive(predicate: Predicate) -> None:
    assert not predicate.passive_subject


def test_somebody_else_does_it_with_arms_of_her_own() -> None:
    assert Predicate("extend", rest="your arm").said_of("of_her").third() == "extends her arm"
    assert Predicate("introduce", object="yourself").said_of("of_somebody").past() == "introduced themselves"


def test_a_sentence_has_a_capital_and_one_mark() -> None:
    assert sentence("did you wait", "?") == "Did you wait?"
    assert sentence("Go to the hall.") == "Go to the hall."
