"""The steps from treebank folders to a packaged model, with what each reads and writes."""

import sys
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Callable, Dict, List, Tuple

from . import generate, lemmas, mining, trainers, treebanks
from .conllu import read, write
from .lexicon import evaluation_words
from .packing import pack
from .steps import Step, execute, tell

_HERE = Path(__file__).resolve().parent
# When one of these sources changes, the sentences must be generated again.
_GENERATOR = (
    "generate.py",
    "sentences.py",
    "verbs.py",
    "motion.py",
    "framewords.py",
    "clauses.py",
    "nouns.py",
    "words.py",
    "trees.py",
    "lexicon.py",
    "mining.py",
    "treebanks.py",
    "conllu.py",
)


@dataclass(frozen=True)
class Plan:
    """The inputs and settings of a build.

    ``commands``: number of generated sentences; ``size``: number of word vectors; ``jobs``: trainings at once.
    """

    ewt: Path
    childes: Path
    wordnet: Path
    work: Path
    out: Path
    seed: int = 20261
    commands: int = 10000
    held_out: int = 1000
    size: int = 22000
    jobs: int = 2
    effort: trainers.Effort = trainers.Effort()


def versions() -> Dict[str, str]:
    """Return the versions of the libraries that train the models and must load them."""
    import stanza
    import torch

    return {"stanza": stanza.__version__, "torch": torch.__version__.split("+")[0]}


def prepare_sentences(plan: Plan) -> None:
    """Select from the treebanks, mine their words, generate commands, and write all training files."""
    data = plan.work / "data"
    source = treebanks.written(plan.ewt)
    banned = evaluation_words()
    written = list(treebanks.without(read(source.train), banned))
    spoken = treebanks.spoken(plan.childes, banned, plan.seed)
    write(data / "written.train.conllu", written)
    write(data / "spoken.conllu", spoken)
    mined = mining.mine([data / "written.train.conllu", data / "spoken.conllu"], banned)
    commands = list(generate.training(plan.commands, plan.seed, mined))
    dev = list(read(source.dev))
    # development sentences of the small models: same words, another seed, and no evaluation words
    others = list(generate.training(300, plan.seed + 1, mined))
    write(data / "commands.conllu", commands)
    write(data / "held-out.conllu", generate.evaluation(plan.held_out, plan.seed))
    write(data / "written.dev.conllu", dev)
    write(data / "mixed.train.conllu", written + commands)
    write(data / "mixed.dev.conllu", dev + others)
    write(data / "parser.train.conllu", written + spoken + commands)
    lemmas.condense(
        [data / "written.train.conllu", data / "spoken.conllu", data / "commands.conllu"], data / "lemma.train.conllu"
    )
    tell(f"      {len(written)} written, {len(spoken)} spoken, {len(commands)} generated sentences")


def prepare_elaborate(plan: Plan) -> None:
    """Generate the sentences of the last steps of the tagger and the parser."""
    data = plan.work / "data"
    mined = mining.mine([data / "written.train.conllu", data / "spoken.conllu"], evaluation_words())
    sentences = list(generate.elaborate(plan.commands * 4 // 5, plan.seed + 3, mined))
    write(data / "elaborate.conllu", sentences)
    write(data / "elaborate.part.conllu", sentences[: len(sentences) * 3 // 8])


def make_vectors(plan: Plan) -> None:
    """Train the word vectors and convert them to Stanza's form.

    This runs in a separate process, because the vectors depend on hashing, which can only be fixed at its start.
    """
    data, models = plan.work / "data", plan.work / "models"
    text = data / "words.vec"
    sources = [treebanks.written(plan.ewt).train] + sorted(plan.childes.glob("**/*.conllu"))
    trainers.run(
        [sys.executable, "-m", "command_models.vectors", str(plan.wordnet), str(text), str(plan.size), str(plan.seed)]
        + [str(source) for source in sources],
        plan.work / "logs" / "vectors.log",
    )
    from stanza.models.common.pretrain import Pretrain

    target = models / "vectors.pt"
    if target.is_file():
        target.unlink()
    Pretrain(str(target), str(text), plan.size).load()


def steps(plan: Plan) -> List[Step]:
    """Return all steps of a plan, the longest first, so that they start first."""
    data, models, logs = plan.work / "data", plan.work / "models", plan.work / "logs"
    treebank_files = tuple(asdict(treebanks.written(plan.ewt)).values()) + tuple(
        sorted(plan.childes.glob("**/*.conllu"))
    )
    generator = tuple(_HERE / name for name in _GENERATOR)
    effort = plan.effort

    def trained(
        name: str,
        command: Callable[[Path, Path, trainers.Effort, int], List[str]],
        output: str,
        inputs: Tuple[Path, ...],
        *,
        may_go_on: bool = False,
    ) -> Step:
        argv = command(data, models, effort, plan.seed)
        log = logs / (name + ".log")
        short = [word.replace(str(plan.work), "") for word in argv[1:]]
        partial = (models / trainers.checkpoint(output[: -len(".pt")]),) if may_go_on else ()
        settings = {"command": " ".join(short)}
        return Step(name, inputs, (models / output,), settings, lambda: trainers.run(argv, log), log, partial)

    def prepared() -> None:
        for command, _ in trainers.preparation(data):
            trainers.run(command, logs / "preparation.log")

    small = tuple(
        data / ("mixed." + name)
        for name in (
            "train.txt",
            "train.toklabels",
            "train.mwt.json",
            "dev.txt",
            "dev.toklabels",
            "dev.mwt.json",
            "dev.contracted.conllu",
        )
    )
    mixed = (data / "mixed.train.conllu", data / "mixed.dev.conllu")
    word_vectors = models / "vectors.pt"
    settled_by = (data / "mixed.dev.conllu", word_vectors, _HERE / "settling.py")
    return [
        Step(
            "sentences",
            treebank_files + generator,
            mixed
            + tuple(
                data / name
                for name in (
                    "parser.train.conllu",
                    "spoken.conllu",
                    "written.dev.conllu",
                    "lemma.train.conllu",
                    "held-out.conllu",
                    "written.train.conllu",
                    "commands.conllu",
                )
            ),
            {"seed": plan.seed, "commands": plan.commands, "held_out": plan.held_out},
            lambda: prepare_sentences(plan),
            logs / "sentences.log",
        ),
        Step(
            "elaborate",
            (data / "written.train.conllu", data / "spoken.conllu", *generator, _HERE / "elaborate.py"),
            (data / "elaborate.conllu", data / "elaborate.part.conllu"),
            {"seed": plan.seed, "commands": plan.commands},
            lambda: prepare_elaborate(plan),
            logs / "elaborate.log",
        ),
        Step(
            "vectors",
            treebank_files + (_HERE / "vectors.py",),
            (word_vectors,),
            {"seed": plan.seed, "size": plan.size},
            lambda: make_vectors(plan),
            logs / "vectors.log",
        ),
        trained(
            "parser",
            trainers.parser,
            "parser-full.pt",
            (data / "parser.train.conllu", data / "written.dev.conllu", word_vectors),
            may_go_on=True,
        ),
        trained(
            "tagger",
            trainers.tagger,
            "tagger-full.pt",
            (data / "mixed.train.conllu", data / "spoken.conllu", data / "written.dev.conllu", word_vectors),
        ),
        trained(
            "settle",
            trainers.settled_parser,
            "parser-settled.pt",
            (models / "parser-full.pt", data / "parser.train.conllu", data / "written.dev.conllu", word_vectors),
            may_go_on=True,
        ),
        trained(
            "settle-longer",
            trainers.settled_longer,
            "parser.pt",
            (
                models / "parser-settled.pt",
                data / "written.train.conllu",
                data / "spoken.conllu",
                data / "commands.conllu",
                data / "elaborate.conllu",
                *settled_by,
            ),
        ),
        trained(
            "settle-tagger",
            trainers.settled_tagger,
            "tagger.pt",
            (
                models / "tagger-full.pt",
                data / "written.train.conllu",
                data / "elaborate.part.conllu",
                *settled_by,
            ),
        ),
        Step("preparation", mixed, small, {}, prepared, logs / "preparation.log"),
        trained("tokenizer", trainers.tokenizer, "tokenizer.pt", small[:5] + (data / "mixed.dev.conllu",)),
        trained("mwt", trainers.mwt, "mwt.pt", mixed + (data / "mixed.dev.contracted.conllu",)),
        trained("lemma", trainers.lemmatizer, "lemma.pt", (data / "lemma.train.conllu", data / "mixed.dev.conllu")),
    ]


def build(plan: Plan) -> None:
    """Run every step that is not done yet, then pack."""
    for name in ("data", "models", "logs", "records"):
        (plan.work / name).mkdir(parents=True, exist_ok=True)
    execute(steps(plan), plan.work / "records", plan.jobs)
    pack_plan(plan.work, plan.out)


def pack_plan(work: Path, out: Path) -> None:
    """Pack the present models of a working folder: trainers save the best so far."""
    packed = pack(work / "models", out, versions())
    for entry in packed:
        tell(f"      {entry.path:<28} {entry.size:9d} bytes")
    tell(f"packed: {sum(entry.size for entry in packed) / 1e6:.1f} MB in {out}")
