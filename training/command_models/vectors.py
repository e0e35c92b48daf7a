"""Trains word vectors: word2vec over treebank text and WordNet glosses.

WordNet is read from its database files (``data.noun`` and so on, WordNet licence). Each gloss follows its lemma in a
form that shows the class of the lemma ("to scrub : clean with hard rubbing", "a mug : ..."), so that words that occur
in no treebank still get a vector that tells verbs from nouns.
"""

import random
import re
import sys
from pathlib import Path
from typing import Dict, Iterable, Iterator, List, Sequence, Tuple

from .conllu import read
from .errors import TrainingError

DIMENSION = 50
EPOCHS = 8
MIN_COUNT = 3

_FRAMES: Dict[str, Tuple[str, ...]] = {
    "noun": ("a", "the"),
    "verb": ("to", "please"),
    "adj": ("very", "a"),
    "adv": ("",),
}
_WORD = re.compile(r"[a-z]+(?:'[a-z]+)?|\d+(?:\.\d+)?|[^\sa-z\d]")


def _tokens(text: str) -> List[str]:
    """Split running text roughly as the treebank does: separate clitics and punctuation, lower case."""
    pieces = []
    for piece in _WORD.findall(text.lower().replace("`", "'")):
        if piece.endswith("n't"):
            pieces += [piece[:-3], "n't"]
        elif "'" in piece and len(piece) > 1:
            stem, _, clitic = piece.partition("'")
            pieces += [stem, "'" + clitic]
        else:
            pieces.append(piece)
    return [piece for piece in pieces if piece]


def gloss_sentences(folder: Path, seed: int) -> Iterator[List[str]]:
    """Return sentences from a WordNet database folder: one definition per lemma, and each usage example.

    Raises TrainingError when the folder lacks one of the four data files.
    """
    chooser = random.Random(seed)
    for kind, frames in _FRAMES.items():
        path = folder / ("data." + kind)
        if not path.is_file():
            raise TrainingError(f"{path}: no such file; expected WordNet 3.0 (Debian: wordnet-base)")
        with path.open(encoding="utf-8", errors="replace") as stream:
            for line in stream:
                if line.startswith("  "):
                    continue
                head, _, gloss = line.partition("|")
                cells = head.split()
                lemmas = [cells[4 + 2 * at].split("(")[0].replace("_", " ") for at in range(int(cells[3], 16))]
                definition, _, examples = gloss.strip().partition('; "')
                for lemma in lemmas:
                    yield _tokens(f"{chooser.choice(frames)} {lemma} : {definition}")
                for example in re.findall(r'"([^"]+)"', '"' + examples):
                    yield _tokens(example)


def treebank_sentences(paths: Iterable[Path]) -> Iterator[List[str]]:
    """Return the forms of every treebank sentence in lower case."""
    for path in paths:
        for sentence in read(path):
            yield [word.form.lower() for word in sentence.words]


def train(treebanks: Iterable[Path], wordnet: Path, target: Path, size: int, seed: int) -> int:
    """Train word2vec and write the ``size`` most frequent words to ``target`` in text form.

    Return the number of training tokens. There is one worker thread, so that a seed always gives the same vectors; the
    caller must fix PYTHONHASHSEED too.
    """
    from gensim.models import Word2Vec  # slow to import, and needed only here

    sentences = list(gloss_sentences(wordnet, seed)) + list(treebank_sentences(treebanks))
    random.Random(seed).shuffle(sentences)
    model = Word2Vec(
        sentences,
        vector_size=DIMENSION,
        window=5,
        min_count=MIN_COUNT,
        sg=1,
        negative=8,
        epochs=EPOCHS,
        workers=1,
        seed=seed,
    )
    words = model.wv.index_to_key[:size]
    with target.open("w", encoding="utf-8") as stream:
        stream.write(f"{len(words)} {DIMENSION}\n")
        for word in words:
            stream.write("{} {}\n".format(word, " ".join(f"{value:.5f}" for value in model.wv[word])))
    return sum(len(sentence) for sentence in sentences)


def main(arguments: Sequence[str]) -> int:
    """Run the step in a separate process: ``vectors WORDNET TARGET SIZE SEED TREEBANK...``."""
    wordnet, target, size, seed = arguments[:4]
    tokens = train([Path(path) for path in arguments[4:]], Path(wordnet), Path(target), int(size), int(seed))
    print(f"vectors over {tokens} tokens")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
