"""The generator builds trees, and its evaluation words stay out of training."""

import random
from dataclasses import fields
from pathlib import Path

import pytest

from command_models import clauses, conllu, elaborate, generate, lexicon, mining, nouns, sentences, trees, verbs, words
from command_models.errors import TrainingError
from command_models.mining import Mined

COUNT = 1500
EMPTY = Mined()


@pytest.fixture(scope="module")
def made():
    return list(generate.training(COUNT, 5, EMPTY))


@pytest.fixture(scope="module")
def held():
    return list(generate.evaluation(400, 5))


def builder(seed):
    return generate.builder(random.Random(seed), lexicon.TRAINING, EMPTY, 0.3)


def relations(sentence):
    return {
        (word.form.lower(), word.deprel, sentence.words[word.head - 1].form.lower() if word.head else "")
        for word in sentence.words
    }


def test_every_sentence_is_a_tree(made, held):
    for sentence in made + held:
        assert conllu.problems(sentence) == []


def test_every_frame_builds_trees():
    build = builder(3)
    for frame in sentences.frame_names():
        for _ in range(60):
            assert conllu.problems(trees.flatten(getattr(build, frame)())) == [], frame


def test_every_frame_of_the_last_steps_builds_trees():
    build = generate.builder(random.Random(3), lexicon.TRAINING, EMPTY, 0.3, elaborate.Elaborate)
    for frame in elaborate.frame_names():
        for _ in range(60):
            assert conllu.problems(trees.flatten(getattr(build, frame)())) == [], frame


def test_sentences_of_the_last_steps_are_others_without_evaluation_words(made):
    last = list(generate.elaborate(600, 5, EMPTY))
    banned = lexicon.evaluation_words()
    assert not any(word.lemma.lower() in banned for sentence in last for word in sentence.words)
    assert any(("twice", "advmod", "turn") in relations(sentence) for sentence in last)
    assert len({one.text() for one in last} - {one.text() for one in made}) > 500


@pytest.mark.parametrize("form", [words.imperative, words.infinitive, words.gerund])
def test_every_verb_frame_builds_trees(form):
    build = builder(4).verbs
    for frame in verbs.frame_names():
        for _ in range(40):
            root = getattr(build, frame)(form)
            assert conllu.problems(trees.flatten(root)) == [], frame


def test_text_fits_the_words(made):
    for sentence in made:
        assert sentence.comment("text") == sentence.text()
        assert "  " not in sentence.text()


def test_known_tags_only(made):
    classes = {word.upos for sentence in made for word in sentence.words}
    assert classes <= set("ADJ ADP ADV AUX CCONJ DET INTJ NOUN NUM PART PRON PROPN PUNCT SCONJ VERB".split())
    tags = {word.xpos for sentence in made for word in sentence.words if word.deprel == "compound:prt"}
    assert tags == {"RP"}


def test_same_seed_same_sentences():
    first = [sentence.text() for sentence in generate.training(80, 9, EMPTY)]
    assert first == [sentence.text() for sentence in generate.training(80, 9, EMPTY)]
    assert first != [sentence.text() for sentence in generate.training(80, 10, EMPTY)]


def test_the_two_lexicons_share_no_word():
    assert not lexicon.content_words(lexicon.TRAINING) & lexicon.evaluation_words()


def test_evaluation_words_never_occur_in_training(made):
    banned = lexicon.evaluation_words()
    for sentence in made:
        for word in sentence.words:
            assert word.form.lower() not in banned
            assert word.lemma.lower() not in banned


def test_mining_leaves_evaluation_words_out(tmp_path):
    path = tmp_path / "bank.conllu"
    conllu.write(path, list(generate.evaluation(200, 3)) + list(generate.training(200, 3, EMPTY)))
    mined = mining.mine([path], lexicon.evaluation_words())
    assert mined.nouns and mined.transitive
    for kind in fields(mined):
        assert not {word.lower() for word in getattr(mined, kind.name)} & lexicon.evaluation_words()


def test_evaluation_uses_the_evaluation_words(held):
    banned = lexicon.evaluation_words()
    hit = sum(any(word.lemma.lower() in banned or word.form.lower() in banned for word in one.words) for one in held)
    assert hit > 0.6 * len(held)


def test_variants_are_all_there(made):
    texts = [sentence.text() for sentence in made]
    capital = sum(text[0].isupper() for text in texts)
    closed = sum(text[-1] in ".?!" for text in texts)
    assert 0.3 * COUNT < capital < 0.7 * COUNT
    assert 0.3 * COUNT < closed < 0.6 * COUNT
    assert any(text[0].islower() and text[-1] not in ".?!" for text in texts)


def test_spoken_style_has_neither_capitals_nor_punctuation():
    build = builder(6)
    for _ in range(200):
        sentence = generate.write_out(build.utterance(), generate.SPOKEN, ".", [])
        assert sentence.text() == sentence.text().lower()
        assert "," not in sentence.text() and sentence.text()[-1] not in ".?!"
        assert conllu.problems(sentence) == []


def test_measures():
    build = nouns.Nouns(random.Random(2), lexicon.TRAINING, EMPTY, 0.0)
    for kind in ("turn", "move", "time"):
        for _ in range(200):
            sentence = trees.flatten(build.measure(kind))
            assert conllu.problems(sentence) == []
            root = next(word for word in sentence.words if word.head == 0)
            assert root.upos == "NOUN"


def test_goal_of_put_hangs_on_the_verb():
    build = builder(7).verbs
    for _ in range(200):
        root = build.placing(words.imperative)
        assert root.has("obj")
        assert root.has("obl") or root.has("advmod")


def test_possessive_is_one_token_of_two_words():
    owner = words.name("Anna").post("case", trees.Node("'s", "'s", "PART", "POS", glued=True))
    root = words.imperative("find").post("obj", words.noun("cup").pre("nmod:poss", owner))
    sentence = trees.flatten(root)
    assert sentence.text() == "find Anna's cup"
    assert [(span.first, span.last, span.form) for span in sentence.spans] == [(2, 3, "Anna's")]
    assert ("anna", "nmod:poss", "cup") in relations(sentence)


def test_relative_clause_is_headed_by_the_place():
    build = nouns.Nouns(random.Random(1), lexicon.TRAINING, EMPTY, 0.0)
    table = words.noun("table").pre("case", words.adposition("on"), words.word("the"))
    sentence = trees.flatten(words.noun("cup").post("acl:relcl", build.relative(table, False)))
    assert sentence.text() == "cup that is on the table"
    assert ("that", "nsubj", "table") in relations(sentence)
    assert ("is", "cop", "table") in relations(sentence)


def test_state_clause_has_subject():
    chooser = random.Random(8)
    build = clauses.Clauses(chooser, nouns.Nouns(chooser, lexicon.TRAINING, EMPTY, 0.1))
    for _ in range(100):
        root = build.state_clause()
        assert any(part.rel.startswith("nsubj") for part in root.left + root.right)


@pytest.mark.parametrize(
    "lemma, form",
    [
        ("box", "boxes"),
        ("knife", "knives"),
        ("battery", "batteries"),
        ("key", "keys"),
        ("foot", "feet"),
    ],
)
def test_plural(lemma, form):
    assert words.plural(lemma) == form


@pytest.mark.parametrize("lemma, form", [("grab", "grabbing"), ("move", "moving"), ("lie", "lying"), ("go", "going")])
def test_ing(lemma, form):
    assert words.ing(lemma) == form


def test_nonce_words_are_letters():
    chooser = random.Random(1)
    for kind in ("NOUN", "VERB", "ADJ", "PROPN"):
        for _ in range(50):
            made = mining.nonce(chooser, kind)
            assert made.isalpha() and len(made) > 1
            assert made[0].isupper() == (kind == "PROPN")


def test_reading_names_file_and_line(tmp_path):
    path = Path(tmp_path) / "broken.conllu"
    path.write_text("1\tstop\tstop\n", encoding="utf-8")
    with pytest.raises(TrainingError) as error:
        list(conllu.read(path))
    assert "broken.conllu, line 1" in str(error.value)


def test_problems_are_found():
    loop = conllu.Sentence(
        (
            conllu.Word("go", "go", "VERB", "VB", "_", 0, "root"),
            conllu.Word("to", "to", "ADP", "IN", "_", 3, "case"),
            conllu.Word("it", "it", "PRON", "PRP", "_", 2, "obl"),
        )
    )
    assert any("circle" in problem for problem in conllu.problems(loop))
    two = conllu.Sentence(
        (conllu.Word("go", "go", "VERB", "VB", "_", 0, "root"), conllu.Word("on", "on", "ADP", "RP", "_", 0, "root"))
    )
    assert any("one root" in problem for problem in conllu.problems(two))


def test_round_trip(tmp_path, made):
    path = tmp_path / "made.conllu"
    conllu.write(path, made[:200])
    assert list(conllu.read(path)) == made[:200]
