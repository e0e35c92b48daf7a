import pytest

from checked_files import FileRefused
from semantic_frames.semantic_type import SEMANTIC_TYPES, with_parents
from semantic_types.likelihood import Fit
from semantic_types.noun_file import load_noun_file
from semantic_types.nouns import NOUN_FILE, shipped_nouns
from semantic_types.wordnet import shipped_wordnet


@pytest.mark.parametrize(
    ("kind", "nouns"),
    [
        ("Human", "nurse, grandmother, guest, boss, colleague, baby, kid, visitors, women"),
        ("Animal", "dog, cat, horse"),
        ("Container", "cup, box, suitcase, drawer, cupboard, wardrobe, envelope, tray, coffee cup, trash can, sink"),
        ("Cookware", "pot, pan, saucepan, wok, skillet"),
        ("Device", "lamp, tv, oven, dishwasher, thermostat, alarm, computer, fridge, washing machine, kettle"),
        ("Valve", "tap, faucet, valve"),
        ("Clothing", "shirt, socks, trousers, sheets, towels, laundry, sweater, shoes"),
        ("Food", "coffee, apple, sandwich, milk, orange juice, lunch"),
        ("Furniture", "table, chair, shelf, bed, sofa"),
        ("Portal", "door, window, gate, curtain"),
        ("Room", "kitchen, living room, bathroom, lobby"),
        ("Location", "hall, corridor, garden, corner, exit, laboratory, elevator, stairs"),
        ("Building", "garage, house, apartment, shop"),
        ("Vehicle", "car, bicycle"),
        ("Body_part", "hand, arm, shoulder"),
        ("Text", "newspaper, letter, book"),
        ("Event", "game, turn, dance"),
        ("Time", "minute, hour"),
        ("Fluid", "water, gas"),
    ],
)
def test_the_likeliest_type_of_a_noun(kind, nouns):
    for noun in nouns.split(", "):
        types = shipped_nouns().types(noun)
        assert types.fit([kind]) is Fit.LIKELY, (noun, types)


@pytest.mark.parametrize(
    ("noun", "kind"),
    [
        ("nurse", "Physical_object"),
        ("hand", "Physical_object"),
        ("kitchen", "Physical_object"),
        ("chair", "Human"),
        ("box", "Human"),
        ("table", "Human"),
        ("idea", "Physical_entity"),
        ("cup", "Device"),
        ("door", "Container"),
        ("fridge", "Container"),
    ],
)
def test_a_noun_of_another_type_is_wrong(noun, kind):
    assert shipped_nouns().types(noun).fit([kind]) is Fit.WRONG


def test_a_rare_sense_is_possible():
    assert shipped_nouns().types("dishwasher").fit(["Device"]) is Fit.LIKELY
    assert shipped_nouns().types("washing").fit(["Clothing"]) is Fit.POSSIBLE


def test_an_unknown_noun_has_no_type():
    types = shipped_nouns().types("frobnicator")
    assert types.names == ()
    assert types.fit(["Device"]) is Fit.UNKNOWN
    assert types.likeliest() == ""


def test_what_fills_an_element_has_the_likeliest_type_that_the_element_accepts():
    table = shipped_nouns().types("table")
    assert table.likeliest() == "Furniture"
    assert table.likeliest(["Quantity"]) == "Quantity"
    assert table.likeliest(["Human"]) == "Furniture"


def test_a_proper_noun_has_only_the_senses_that_are_spelled_with_a_capital():
    assert shipped_nouns().types("ben").likeliest() == "Location"
    assert shipped_nouns().types("Paris", is_name=True).likeliest() == "Location"
    assert shipped_nouns().types("Anna", is_name=True).names == ()
    assert shipped_nouns().types("Sam", is_name=True).names == ()


def test_likelihoods_add_up_to_one():
    for noun in ("cup", "light", "elevator", "kettle"):
        assert sum(share for _, share in shipped_nouns().types(noun).types) == pytest.approx(1.0)


def test_one_thing_called_glasses_is_no_glass():
    glass = shipped_nouns().synsets("glass")
    assert glass & shipped_nouns().kinds("wineglass")
    assert not glass & shipped_nouns().kinds("glasses")
    assert glass & shipped_nouns().synsets("glasses")


def test_every_type_is_used_and_ends_in_a_root():
    text = NOUN_FILE.read_text(encoding="utf-8")
    for name, kind in SEMANTIC_TYPES.items():
        assert name in with_parents(name)
        assert kind.words
        assert f"  {name}:\n" in text or any(other.parent == name for other in SEMANTIC_TYPES.values())


@pytest.mark.parametrize(
    ("text", "code", "key"),
    [
        ("synsets: {Persn: [person.n.01]}", "UNKNOWN_TYPE", "synsets.'Persn'"),
        ("synsets: {Human: [persn.n.01]}", "UNKNOWN_SYNSET", "synsets.Human[0]"),
        ("synsets: {Human: [person.n.01, person.n.01]}", "DUPLICATE_SYNSET", "synsets.Human[1]"),
        ("synsets: {Human: [{synset: person.n.01}]}", "MISSING_KEY", "synsets.Human[0].because"),
        ("synsets: {}\nkinds: [{synset: lamp.n.01, is_also: lght.n.02, because: x}]", "UNKNOWN_SYNSET", "kinds[0]"),
        ("synsets: {}\nkinds: [{synset: lamp.n.01, because: x}]", "MISSING_KEY", "kinds[0].is_also"),
        ("synsets: {}\nwords: {tap: {types: [Valv], because: x}}", "UNKNOWN_TYPE", "words.tap.types[0]"),
        (
            "synsets: {}\nwords: {tap: {types: Valve, because: x}, TAP: {types: Valve, because: x}}",
            "DUPLICATE_WORD",
            "words.tap",
        ),
        ("synsets: {}\nwords: [tap]", "WRONG_TYPE", "words"),
        ("words: {}", "MISSING_KEY", "synsets"),
    ],
)
def test_a_mistake_in_the_file_has_its_line_and_key(text, code, key):
    with pytest.raises(FileRefused) as refused:
        load_noun_file(text, "nouns.yaml", shipped_wordnet())
    problem = refused.value.problems[0]
    assert (problem.code, problem.key, problem.path) == (code, key, "nouns.yaml")
    assert problem.line == text.count("\n") + 1
    assert problem.found
    assert problem.expected


def test_a_synset_that_is_named_twice_is_told_by_its_name():
    text = "synsets: {Human: [person.n.01, {synset: person.n.01, because: x}]}"
    with pytest.raises(FileRefused) as refused:
        load_noun_file(text, "nouns.yaml", shipped_wordnet())
    assert "person.n.01" in refused.value.problems[0].found
