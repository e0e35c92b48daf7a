"""Readers of corpora, and the figures, on made-up data."""

import json

import pytest

from checked_files import FileRefused
from frame_learning import learn_command, score_command
from frame_learning.annotated_commands import AnnotatedElement, AnnotatedFrame, CorpusError, command_of, positions_at
from frame_learning.corpora import CORPORA, Corpus, PublishedFigures
from frame_learning.corpus_answers import answer, answer_2012
from frame_learning.corpus_mapping import CorpusMapping, load_mapping
from frame_learning.huric_corpus import read_huric
from frame_learning.metrics import Answer, score
from frame_learning.score_command import to_json
from frame_learning.tage_corpus import read_tage
from offline_pipeline.knowledge import load_knowledge, pretend_servers, shipped_domains
from offline_pipeline.pipeline import Pipeline

HURIC = """<?xml version="1.0"?>
<huricExample id="1"><commands><command>
<sentence>take the lid to her</sentence>
<tokens>
<token id="1" lemma="take" pos="VB" surface="take"/><token id="2" lemma="the" pos="DT" surface="the"/>
<token id="3" lemma="lid" pos="NN" surface="lid"/><token id="4" lemma="to" pos="TO" surface="to"/>
<token id="5" lemma="her" pos="PRP" surface="her"/>
</tokens>
<semantics><frames><frame name="Bringing">
<lexicalUnit><token id="1"/></lexicalUnit>
<frameElements>
<frameElement type="Theme" semanticHead="3"><token id="2"/><token id="3"/></frameElement>
<frameElement type="Beneficiary"><token id="4"/><token id="5"/></frameElement>
</frameElements>
</frame></frames></semantics>
</command></commands></huricExample>
"""


def frame(name, *elements):
    """Make a frame of elements (name, tokens, head)."""
    return AnnotatedFrame(
        name, (1,), tuple(AnnotatedElement(kind, frozenset(tokens), head) for kind, tokens, head in elements)
    )


def command(*frames):
    """Make a command with frames."""
    return command_of("1", "take the lid to her", "take the lid to her".split(), frames)


THEME = ("Theme", (2, 3), 3)
TO_HER = ("Beneficiary", (4, 5), 5)


def test_huric_is_read(tmp_path):
    (tmp_path / "1.hrc").write_text(HURIC, encoding="utf-8")
    (read,) = read_huric(str(tmp_path))
    assert read.frames == (frame("Bringing", THEME, ("Beneficiary", (4, 5), None)),)
    assert positions_at(read, [(5, 6), (16, 19)]) == {2, 5}


@pytest.mark.parametrize("text", ["", "<huricExample", HURIC.replace('surface="lid"', "")])
def test_huric_that_is_wrong_is_named(tmp_path, text):
    (tmp_path / "1.hrc").write_text(text, encoding="utf-8")
    with pytest.raises(CorpusError, match=r"1\.hrc"):
        read_huric(str(tmp_path))


@pytest.mark.parametrize("corpus", CORPORA.values(), ids=lambda corpus: corpus.name)
def test_an_empty_folder_is_no_corpus(tmp_path, corpus):
    with pytest.raises(CorpusError):
        corpus.read(str(tmp_path))


def test_tage_is_read(tmp_path):
    (tmp_path / "dev.csv").write_text(
        "input,tage_output,seq2seq_output\n"
        "go left grab the red lid,0 0 Motion ; 1 1 Manner| 2 2 Picking ; 4 5 Theme -4 4 isColour,x\n",
        encoding="utf-8",
    )
    (read,) = read_tage(str(tmp_path))
    assert [item.name for item in read.frames] == ["Motion", "Picking"]
    assert read.frames[1].lexical_unit == (3,)
    assert read.frames[1].elements == (AnnotatedElement("Theme", frozenset([5, 6]), 6),)


def test_scout_is_what_a_person_said(tmp_path):
    (tmp_path / "x_transcript.txt").write_text(
        'id\ttime\tstream\ttext\n0\t1.0\tCMD\t"uh <inhale> turn left"\n1\t2.0\tRN\t"done"\n', encoding="utf-8"
    )
    (read,) = CORPORA["scout"].read(str(tmp_path))
    assert (read.name, read.text, read.frames) == ("x_transcript:2", "uh turn left", ())


def test_text_that_is_not_its_words_is_made_of_them():
    assert command_of("1", "Take  it", ["Take", "it"], ()).text == "Take  it"
    assert command_of("1", "Take that", ["Take", "it"], ()).text == "Take it"


def test_everything_right():
    right = frame("Bringing", THEME, TO_HER)
    found = score([(command(right), Answer((right,), True, 4.0))])
    assert (found.fp, found.aic_exact, found.aic_head, found.em) == (100.0, 100.0, 100.0, 100.0)
    assert (found.coverage, found.precision_answered, found.ms_per_command) == (100.0, 100.0, 4.0)


def test_span_and_head_are_counted_apart():
    narrow = frame("Bringing", ("Theme", (3,), 3), TO_HER)
    found = score([(command(frame("Bringing", THEME, TO_HER)), Answer((narrow,), True, 1.0))])
    assert (found.fp, found.aic_exact, found.aic_head, found.em) == (100.0, 50.0, 100.0, 0.0)


def test_a_wrong_frame_makes_its_elements_wrong():
    found = score([(command(frame("Bringing", THEME)), Answer((frame("Taking", THEME),), True, 1.0))])
    assert (found.fp, found.aic_exact, found.aic_head, found.precision_answered) == (0.0, 0.0, 0.0, 0.0)
    assert found.per_frame["Bringing"].taken_for == {"Taking": 1}


def test_f1_counts_what_is_too_much_and_what_is_missing():
    wanted = command(frame("Taking", THEME), frame("Motion"))
    given = Answer((frame("Taking", THEME), frame("Giving"), frame("Giving")), True, 1.0)
    found = score([(wanted, given)])
    assert found.fp == pytest.approx(100.0 * 2 * 1 / (3 + 2))
    assert found.precision_answered == pytest.approx(100.0 / 3)
    assert found.right_answered == 0.0


def test_a_frame_twice_is_wanted_twice():
    found = score([(command(frame("Motion"), frame("Motion")), Answer((frame("Motion"),), True, 1.0))])
    assert found.fp == pytest.approx(200.0 / 3)


def test_precision_is_over_answered_commands_alone():
    wanted = command(frame("Motion"))
    pairs = [(wanted, Answer((frame("Motion"),), True, 1.0)), (wanted, Answer((frame("Taking"),), False, 1.0))]
    assert (score(pairs).coverage, score(pairs).precision_answered) == (50.0, 100.0)


def test_where_no_head_is_annotated_a_word_of_the_span_is_right():
    wanted = command(frame("Bringing", ("Theme", (2, 3), None)))
    inside = Answer((frame("Bringing", ("Theme", (3,), 3)),), True, 1.0)
    outside = Answer((frame("Bringing", ("Theme", (5,), 5)),), True, 1.0)
    assert (score([(wanted, inside)]).aic_head, score([(wanted, outside)]).aic_head) == (100.0, 0.0)


def test_nothing_scored_is_zero_and_no_error():
    assert score([]).fp == 0.0


def test_json_has_the_agreed_keys():
    keys = "commands fp aic_exact aic_head em coverage precision_answered ms_per_command per_frame".split()
    assert list(to_json(score([(command(frame("Motion")), Answer((), False, 1.0))]))) == keys


def test_mapping_names_what_is_listed_and_framenet_else():
    frames = load_knowledge([shipped_domains()]).frames
    mapping = CORPORA["huric"].mapping()
    assert mapping.frame_name(frames["moving"]) == "Motion"
    assert mapping.frame_name(frames["taking"]) == "Taking"
    assert mapping.element_name(frames["detaching"], "source") == "Goal"
    assert mapping.element_name(frames["taking"], "source") == "Source"
    assert mapping.element_name(frames["taking"], "beneficiary") is None


@pytest.mark.parametrize(
    "corpus", [corpus for corpus in CORPORA.values() if corpus.is_annotated], ids=lambda corpus: corpus.name
)
def test_mappings_name_frames_and_elements_that_exist(corpus):
    frames = load_knowledge([shipped_domains()]).frames
    mapping = corpus.mapping()
    assert set(mapping.frames) - set(frames) == set()
    for name, elements in mapping.elements.items():
        known = {element.name for element in frames[name].frame_elements} if name != "all" else set(elements)
        assert set(elements) - known == set(), name


def test_a_wrong_mapping_is_refused_with_its_line(tmp_path):
    path = tmp_path / "x.yaml"
    path.write_text("frames:\n  moving: Motion\nframe: {}\n", encoding="utf-8")
    with pytest.raises(FileRefused, match="UNKNOWN_KEY"):
        load_mapping(str(path))


@pytest.fixture(scope="module")
def pipeline():
    knowledge = load_knowledge([shipped_domains()])
    pretend_servers(knowledge.graph)
    return Pipeline(knowledge)


def test_answer_is_in_names_and_positions_of_the_corpus(pipeline):
    wanted = command(frame("Bringing", THEME, TO_HER))
    given = answer(pipeline, CORPORA["huric"].mapping(), wanted)
    assert given.frames == (frame("Bringing", THEME, TO_HER),)
    assert given.is_answered


def test_in_2012_an_argument_was_one_word(pipeline):
    given = answer_2012(
        pipeline, CORPORA["huric"].mapping(), command_of("1", "lift the lid", "lift the lid".split(), ())
    )
    assert given.frames == (frame("Cause_motion", ("Theme", (3,), 3)),)


def test_spans_by_the_habits_of_a_corpus(pipeline):
    text = "bring the lid to the front of the oven"
    mapping = CorpusMapping({}, {}, frozenset(["to", "the"]), frozenset(["front"]), True)
    (found,) = answer(pipeline, mapping, command_of("1", text, text.split(), ())).frames
    assert {element.name: (sorted(element.tokens), element.head) for element in found.elements} == {
        "Theme": ([3], 3),
        "Goal": ([6, 7, 8, 9], 9),
    }


def test_command_line_prints_the_object(tmp_path, capsys):
    (tmp_path / "1.hrc").write_text(HURIC, encoding="utf-8")
    parser = score_command.argparse.ArgumentParser()
    score_command.add_arguments(parser)
    assert score_command.run(parser.parse_args(["huric", str(tmp_path), "--json"])) == 0
    printed = json.loads(capsys.readouterr().out)
    assert (printed["commands"], printed["em"]) == (1, 100.0)
    assert score_command.run(parser.parse_args(["tage", str(tmp_path)])) == 2
    assert "tagE" in capsys.readouterr().err


BRING = """<?xml version="1.0"?>
<huricExample id="2"><commands><command>
<sentence>bring the book on the table in the kitchen</sentence>
<tokens>{tokens}</tokens>
<semantics><frames><frame name="Bringing">
<lexicalUnit><token id="1"/></lexicalUnit>
<frameElements>
<frameElement type="Theme" semanticHead="3"><token id="2"/><token id="3"/></frameElement>
<frameElement type="Goal" semanticHead="6">{goal}</frameElement>
</frameElements>
</frame></frames></semantics>
</command></commands>
<semanticMap><entities>
<entity atom="book_1" type="Book"><attributes/><coordinate angle="0.0" x="{book}" y="0.0" z="0.0"/></entity>
<entity atom="table_1" type="Table"><attributes/><coordinate angle="0.0" x="9.0" y="0.0" z="0.0"/></entity>
<entity atom="kitchen_1" type="Kitchen"><attributes/><coordinate angle="0.0" x="9.0" y="1.0" z="0.0"/></entity>
</entities></semanticMap></huricExample>
"""


@pytest.mark.parametrize(("book", "is_right"), [(0.0, True), (9.0, False)])
def test_maps_attach_places(book, is_right, tmp_path, capsys):
    words = "bring the book on the table in the kitchen".split()
    tokens = "".join(f'<token id="{number}" surface="{word}"/>' for number, word in enumerate(words, start=1))
    goal = "".join(f'<token id="{number}"/>' for number in range(4, 10))
    (tmp_path / "2.hrc").write_text(BRING.format(tokens=tokens, goal=goal, book=book), encoding="utf-8")
    parser = score_command.argparse.ArgumentParser()
    score_command.add_arguments(parser)
    assert score_command.run(parser.parse_args(["huric", str(tmp_path), "--maps", "--json"])) == 0
    printed = json.loads(capsys.readouterr().out)
    assert (printed["em"], printed["maps"]["em"]) == (0.0, 100.0 if is_right else 0.0)
    assert printed["maps"]["attachments"] == {"wrong": {"2": is_right}, "lost": []}
    assert score_command.run(parser.parse_args(["huric", str(tmp_path), "--maps"])) == 0
    assert f"1 wrong without maps, {int(is_right)} of these right with them" in capsys.readouterr().out
    assert score_command.run(parser.parse_args(["huric", str(tmp_path), "--maps", "--folds", "2"])) == 2
    assert score_command.run(parser.parse_args(["scout", str(tmp_path), "--maps"])) == 2


def test_scout_counts_every_line(tmp_path, capsys):
    lines = ["stop", "turn left", "uhm", "<no speech>", "", "stop there"]
    rows = "".join(f'{number}\t1.0\tCMD\t"{line}"\n' for number, line in enumerate(lines))
    (tmp_path / "x_transcript.txt").write_text("id\ttime\tstream\ttext\n" + rows, encoding="utf-8")
    parser = score_command.argparse.ArgumentParser()
    score_command.add_arguments(parser)
    assert score_command.run(parser.parse_args(["scout", str(tmp_path), "--json"])) == 0
    found = json.loads(capsys.readouterr().out)
    counts = {"answered": 1, "talk": 0, "asked_back": 0, "asked_to_leave_out": 0, "refused": 3, "stops": 2, "errors": 0}
    assert {name: found[name] for name in counts} == counts
    assert found["lines"] == 6
    assert found["codes"] == {"EMPTY_TEXT": 2, "NO_VERB": 1}
    # Two of the lines have no words.
    assert found["different"]["lines"] == 4


def test_scout_shows_a_seeded_sample_of_what_is_acted_on(tmp_path, capsys):
    rows = "".join(f'{number}\t1.0\tCMD\t"{line}"\n' for number, line in enumerate(["turn left", "Turn left.", "uhm"]))
    (tmp_path / "x_transcript.txt").write_text("id\ttime\tstream\ttext\n" + rows, encoding="utf-8")
    parser = score_command.argparse.ArgumentParser()
    score_command.add_arguments(parser)
    assert score_command.run(parser.parse_args(["scout", str(tmp_path), "--sample", "5", "--seed", "1"])) == 0
    shown = capsys.readouterr().out
    assert "1 different utterances that are acted on, seed 1" in shown
    assert "turn left | turning(direction=left" in shown


@pytest.mark.parametrize("words", [["--folds", "2"], ["--behaviour", "2012"]])
def test_what_needs_annotated_frames_is_refused_without_them(tmp_path, capsys, words):
    parser = score_command.argparse.ArgumentParser()
    score_command.add_arguments(parser)
    assert score_command.run(parser.parse_args(["scout", str(tmp_path)] + words)) == 2
    assert "scout has no annotated frames" in capsys.readouterr().err


def read_made_up(folder):
    """Read the one command of a corpus that somebody has just added."""
    return (command_of("1", "take the lid", "take the lid".split(), (frame("Taking", THEME),)),)


@pytest.fixture
def made_up(monkeypatch):
    """Add a corpus in the one place where corpora are listed."""
    others = (PublishedFigures("somebody 2020", fp=50.0, aic_exact=40.0, aic_head=30.0),)
    corpus = Corpus("made_up", "made up", read_made_up, mapping_file="huric.yaml", published=others)
    monkeypatch.setitem(CORPORA, "made_up", corpus)


def test_a_new_corpus_is_scored(made_up, tmp_path, capsys):
    parser = score_command.argparse.ArgumentParser()
    score_command.add_arguments(parser)
    assert score_command.run(parser.parse_args(["made_up", str(tmp_path)])) == 0
    lines = [line.split() for line in capsys.readouterr().out.splitlines()]
    assert ["now", "100.0", "100.0"] in [line[:3] for line in lines]
    assert ["somebody", "2020", "50.0", "40.0", "30.0"] in [line[:5] for line in lines]


def test_a_new_corpus_teaches(made_up, tmp_path):
    parser = learn_command.argparse.ArgumentParser()
    learn_command.add_arguments(parser)
    assert learn_command.run(parser.parse_args(["made_up", str(tmp_path), "--out", str(tmp_path / "learned")])) == 0
    assert (tmp_path / "learned" / "lexical_units" / "taking.yaml").exists()
