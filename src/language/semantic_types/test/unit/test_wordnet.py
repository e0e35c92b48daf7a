import random

import pytest

from semantic_types.wordnet import FOLDER, VERB, NoWordNet, WordNet, shipped_wordnet


@pytest.fixture(scope="module")
def wordnet():
    return shipped_wordnet()


def test_senses_come_with_the_most_frequent_first(wordnet):
    senses = wordnet.senses("cup")
    assert len(senses) == 8
    assert [sense.count for sense in senses[:3]] == [14, 7, 2]


def test_a_plural_that_is_a_noun_of_its_own_has_the_senses_of_its_singular_too(wordnet):
    spectacles = wordnet.synset("spectacles.n.01")
    glass = wordnet.synset("glass.n.02")
    assert {spectacles, glass} <= {sense.synset for sense in wordnet.senses("glasses")}


def test_every_noun_of_the_index_is_found(wordnet):
    lines = [line for line in (FOLDER / "index.noun").read_text().split("\n") if line and not line.startswith(" ")]
    sample = lines[:3] + lines[-3:] + random.Random(1).sample(lines, 500)
    for line in sample:
        key, _, count = line.split()[:3]
        assert len(wordnet.senses(key.replace("_", " "))) >= int(count)


@pytest.mark.parametrize(
    ("said", "noun"),
    [
        ("cups", "cup"),
        ("boxes", "box"),
        ("batteries", "battery"),
        ("women", "woman"),
        ("dishes", "dish"),
        ("mice", "mouse"),
        ("shelves", "shelf"),
        ("trousers", "trouser"),
        ("Living  Rooms", "living room"),
    ],
)
def test_a_plural_has_the_senses_of_its_singular(wordnet, said, noun):
    assert [sense.synset for sense in wordnet.senses(said)] == [sense.synset for sense in wordnet.senses(noun)] != []


@pytest.mark.parametrize("noun", ["", " ", "frobnicator", "zzz", "büro", "\n", "s", "men\x00"])
def test_other_text_has_no_sense_and_does_no_harm(wordnet, noun):
    assert noun == "s" or not wordnet.senses(noun)


@pytest.mark.parametrize(("name", "is_known"), [("person.n.01", True), ("living_room.n.01", True), ("cup.n.09", False)])
def test_a_synset_has_a_name(wordnet, name, is_known):
    assert (wordnet.synset(name) is not None) == is_known


@pytest.mark.parametrize("name", ["person", "person.v.01", "person.n.x", "person.n.00", "..", ""])
def test_a_wrong_name_is_no_synset(wordnet, name):
    assert wordnet.synset(name) is None


def test_an_instance_has_a_hypernym(wordnet):
    paris = wordnet.senses("Paris")[0]
    assert paris.spelling == "Paris"
    assert wordnet.hypernyms(paris.synset)


def test_without_the_database_the_error_says_what_to_install(tmp_path):
    with pytest.raises(NoWordNet, match="wordnet-base"):
        WordNet(tmp_path)


def test_a_verb_has_senses_and_more_general_verbs():
    verbs = shipped_wordnet(VERB)
    (veer, *_) = verbs.senses("veer")
    assert veer.count == 8
    assert {"turn"} <= {word for above in verbs.hypernyms(veer.synset) for word in verbs.words(above)}
    assert "bring" in verbs.words(verbs.senses("fetch")[0].synset)
    assert not verbs.senses("veers")


def test_nouns_and_verbs_are_apart(wordnet):
    assert wordnet.synset("veer.v.01") is None
    assert shipped_wordnet(VERB).synset("cup.n.01") is None
