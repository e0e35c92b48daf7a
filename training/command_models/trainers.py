"""Builds and runs the command lines of Stanza's own trainers.

Every value here was found by trial. The README explains why dropout is low, why the biaffine layers are small and why
``--pos_dim`` equals ``--emb_dim``.
"""

import os
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Dict, List, Tuple

from .errors import TrainingError

NICE = 5


@dataclass(frozen=True)
class Effort:
    """Length of each training: steps, or epochs if the trainer counts those. The shipped models have these."""

    tokenizer: int = 6000
    mwt: int = 10
    lemma: int = 4
    tagger: int = 1600
    parser: int = 3900
    settle: int = 450  # the parser's next steps, at a quarter of the learning rate
    settle_longer: int = 600  # and its last ones, averaged
    settle_tagger: int = 500  # the tagger's last ones, at a fifth


def _module(name: str, options: str = "") -> List[str]:
    return [sys.executable, "-m", "stanza." + name] + options.split()


def _trainer(name: str, options: str = "") -> List[str]:
    return [sys.executable, "-m", "command_models.reproducible", name] + options.split()


def tokenizer(data: Path, models: Path, effort: Effort, seed: int) -> List[str]:
    """Tokenizer over running text and character labels."""
    return _trainer(
        "stanza.models.tokenizer",
        "--mode train --lang en --shorthand en_cmd --cpu --use_mwt --max_seqlen 200 "
        "--batch_size 32 --eval_steps 500 --max_steps_before_stop 3000 --last_char_drop_prob 0.3",
    ) + [
        "--steps",
        str(effort.tokenizer),
        "--seed",
        str(seed),
        "--txt_file",
        str(data / "mixed.train.txt"),
        "--label_file",
        str(data / "mixed.train.toklabels"),
        "--mwt_json_file",
        str(data / "mixed.train.mwt.json"),
        "--dev_txt_file",
        str(data / "mixed.dev.txt"),
        "--dev_label_file",
        str(data / "mixed.dev.toklabels"),
        "--dev_conll_gold",
        str(data / "mixed.dev.conllu"),
        "--conll_file",
        str(data / "tokenizer.predicted.conllu"),
        "--save_dir",
        str(models),
        "--save_name",
        "tokenizer.pt",
    ]


def mwt(data: Path, models: Path, effort: Effort, seed: int) -> List[str]:
    """Multi-word token expander ("Roger's", "don't")."""
    return _trainer(
        "stanza.models.mwt_expander", "--mode train --lang en --shorthand en_cmd --cpu --hidden_dim 50 --emb_dim 32"
    ) + [
        "--num_epoch",
        str(effort.mwt),
        "--decay_epoch",
        str(max(1, effort.mwt * 2 // 3)),
        "--seed",
        str(seed),
        "--train_file",
        str(data / "mixed.train.conllu"),
        "--eval_file",
        str(data / "mixed.dev.contracted.conllu"),
        "--gold_file",
        str(data / "mixed.dev.conllu"),
        "--save_dir",
        str(models),
        "--save_name",
        "mwt.pt",
    ]


def lemmatizer(data: Path, models: Path, effort: Effort, seed: int) -> List[str]:
    """Lemmatizer; pos_dim has to equal emb_dim in this version of Stanza."""
    return _trainer(
        "stanza.models.lemmatizer",
        "--mode train --shorthand en_cmd --cpu --decay_epoch 10 --hidden_dim 100 "
        "--emb_dim 40 --pos_dim 40 --batch_size 100",
    ) + [
        "--num_epoch",
        str(effort.lemma),
        "--seed",
        str(seed),
        "--train_file",
        str(data / "lemma.train.conllu"),
        "--eval_file",
        str(data / "mixed.dev.conllu"),
        "--save_dir",
        str(models),
        "--save_name",
        "lemma.pt",
    ]


def tagger(data: Path, models: Path, effort: Effort, seed: int) -> List[str]:
    """Tagger; spoken sentences have no features and form a second file, which trains no feature head."""
    return _trainer(
        "stanza.models.tagger",
        "--mode train --lang en --shorthand en_ewt --cpu --word_cutoff 2 --dropout 0.3 "
        "--word_dropout 0.2 --hidden_dim 200 --num_layers 1 --char_hidden_dim 80 --char_emb_dim 40 "
        "--deep_biaff_hidden_dim 100 --composite_deep_biaff_hidden_dim 50 --word_emb_dim 75 "
        "--transformed_dim 75 --tag_emb_dim 30 --batch_size 64 --lr 0.002 --eval_interval 400 "
        "--fix_eval_interval --max_steps_before_stop 1500",
    ) + [
        "--max_steps",
        str(effort.tagger),
        "--seed",
        str(seed),
        "--train_file",
        "{};{}".format(data / "mixed.train.conllu", data / "spoken.conllu"),
        "--eval_file",
        str(data / "written.dev.conllu"),
        "--wordvec_pretrain_file",
        str(models / "vectors.pt"),
        "--save_dir",
        str(models),
        "--save_name",
        "tagger-full.pt",
    ]


def settled_tagger(data: Path, models: Path, effort: Effort, seed: int) -> List[str]:
    """The best tagger, trained further at a fifth of the rate, with other commands than before, and fewer."""
    train = [data / "written.train.conllu", data / "elaborate.part.conllu"]
    return _settled("tagger", "tagger-full.pt", "tagger.pt", data, models, effort.settle_tagger, seed + 1, train)


def _settled(
    kind: str, source: str, target: str, data: Path, models: Path, steps: int, seed: int, train: List[Path]
) -> List[str]:
    command = _trainer("command_models.settling") + [kind]
    files = [models / source, models / target, models / "vectors.pt", data / "mixed.dev.conllu"]
    return command + [str(path) for path in files] + [str(steps), str(seed)] + [str(path) for path in train]


_PARSER = (
    "--mode train --lang en --shorthand en_ewt --cpu --word_cutoff 2 --no_ufeats --dropout 0.3 "
    "--word_dropout 0.2 --hidden_dim 200 --num_layers 2 --char_hidden_dim 60 --char_emb_dim 30 "
    "--deep_biaff_hidden_dim 80 --tag_emb_dim 30 --word_emb_dim 60 --transformed_dim 60 --batch_size 1000 "
    "--optim adam --no_second_optim --beta2 0.95 --weight_decay 0 --max_steps_before_stop 3000 "
)


def _parser_files(data: Path, models: Path) -> List[str]:
    return [
        "--train_file",
        str(data / "parser.train.conllu"),
        "--eval_file",
        str(data / "written.dev.conllu"),
        "--wordvec_pretrain_file",
        str(models / "vectors.pt"),
        "--save_dir",
        str(models),
    ]


def parser(data: Path, models: Path, effort: Effort, seed: int) -> List[str]:
    """Parser at full learning rate; its scores still rise at the end."""
    steps = ["--max_steps", str(effort.parser), "--seed", str(seed), *_named("parser-full")]
    command = _trainer("stanza.models.parser", _PARSER + "--lr 0.002 --eval_interval 300")
    return command + steps + _parser_files(data, models)


def settled_parser(data: Path, models: Path, effort: Effort, seed: int) -> List[str]:
    """The best parser so far, trained further at a quarter of the learning rate."""
    steps = ["--max_steps", str(effort.settle), "--seed", str(seed + 1), *_named("parser-settled")]
    source = ["--continue_from", str(models / "parser-full.pt")]
    command = _trainer("stanza.models.parser", _PARSER + "--lr 0.0005 --eval_interval 150")
    return command + steps + source + _parser_files(data, models)


def settled_longer(data: Path, models: Path, effort: Effort, seed: int) -> List[str]:
    """The settled parser, trained to the end at the same rate, with more commands and the average of its weights."""
    train = [data / f"{name}.conllu" for name in ("written.train", "spoken", "commands", "elaborate")]
    return _settled("parser", "parser-settled.pt", "parser.pt", data, models, effort.settle_longer, seed + 2, train)


def _named(name: str) -> List[str]:
    return ["--save_name", f"{name}.pt", "--checkpoint_save_name", checkpoint(name)]


def checkpoint(name: str) -> str:
    """Return the file from which an interrupted training of a parser goes on; Stanza writes it with each evaluation."""
    return f"{name}.checkpoint.pt"


def preparation(data: Path) -> List[Tuple[List[str], str]]:
    """Return the commands that convert the mixed treebanks for the tokenizer and the expander."""
    commands: List[Tuple[List[str], str]] = []
    for part in ("train", "dev"):
        stem = data.resolve() / ("mixed." + part)
        commands.append((_module("utils.datasets.conllu_to_text") + [f"{stem}.conllu", f"{stem}.txt"], part))
        commands.append(
            (
                _module("utils.datasets.prepare_tokenizer_data")
                + [f"{stem}.txt", f"{stem}.conllu", "-o", f"{stem}.toklabels", "-m", f"{stem}.mwt.json"],
                part,
            )
        )
    stem = data.resolve() / "mixed.dev"
    commands.append((_module("utils.datasets.contract_mwt") + [f"{stem}.conllu", f"{stem}.contracted.conllu"], "dev"))
    return commands


#: The kernels of torch, oneDNN, MKL and OpenBLAS that every processor with AVX2 has. MKL offers only "COMPATIBLE" to
#: all makes; ``reproducible`` replaces what differs even there. OpenBLAS, which SciPy brings along, trains the word
#: vectors.
ARITHMETIC = {
    "ATEN_CPU_CAPABILITY": "avx2",
    "ONEDNN_MAX_CPU_ISA": "AVX",
    "MKL_CBWR": "COMPATIBLE",
    "OPENBLAS_CORETYPE": "Haswell",
}


def environment() -> Dict[str, str]:
    """Return the environment of a trainer: one thread, no downloads from a model hub, fixed hashing, one arithmetic.

    Libraries choose their kernels by the processor, and kernels round differently: without a fixed choice, the same
    command makes other models on another machine.
    """
    changed = dict(os.environ)
    changed.update({"OMP_NUM_THREADS": "1", "HF_HUB_OFFLINE": "1", "PYTHONHASHSEED": "0", **ARITHMETIC})
    # a trainer may be a module of this package, which need not be installed
    here = str(Path(__file__).resolve().parent.parent)
    changed["PYTHONPATH"] = os.pathsep.join(part for part in (here, changed.get("PYTHONPATH", "")) if part)
    return changed


def run(command: List[str], log: Path) -> None:
    """Run one trainer at low priority, with its output in ``log``.

    Raises TrainingError with the end of the log when it fails.
    """
    with log.open("ab") as stream:
        ended = subprocess.run(
            ["nice", "-n", str(NICE)] + command,
            stdout=stream,
            stderr=subprocess.STDOUT,
            env=environment(),
            check=False,
        )
    if ended.returncode != 0:
        tail = " / ".join(log.read_text(encoding="utf-8", errors="replace").splitlines()[-3:])
        raise TrainingError(f"exit status {ended.returncode}: {tail}")
