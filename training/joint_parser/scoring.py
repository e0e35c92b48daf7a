"""Scores of trees: tags, heads, relations, whole trees, by construction."""

from collections import defaultdict
from typing import Any, Callable, Dict, List, NamedTuple, Sequence, Tuple

import numpy as np

from joint_parser.data import Batches, Example, Labels
from stanford_parser_ros.joint.spanning_tree import heads_of_best_tree


class Parsed(NamedTuple):
    """What a model says of a sentence."""

    upos: Tuple[str, ...]
    xpos: Tuple[str, ...]
    feats: Tuple[str, ...]
    head: Tuple[int, ...]
    deprel: Tuple[str, ...]


def decoded(scores: Dict[str, Any], labels: Labels) -> Parsed:
    """Return the best tree and tags.

    Args:
        scores: arrays of one sentence, as the network returns them
        labels: of the network
    """
    arcs = scores["arcs"].astype(np.float64)
    arcs = arcs - np.logaddexp.reduce(arcs, axis=1, keepdims=True)
    square = np.full((len(arcs) + 1, len(arcs) + 1), -np.inf)
    square[1:] = arcs
    heads = heads_of_best_tree(square)[1:]
    root = labels.deprel.index("root")
    relations = []
    for word, head in enumerate(heads):
        of_head = scores["relations"][word, head].copy()
        if head == 0:
            relations.append("root")
            continue
        of_head[root] = -np.inf
        relations.append(labels.deprel[int(of_head.argmax())])
    tags = [tuple(getattr(labels, kind)[n] for n in scores[kind].argmax(1)) for kind in ("upos", "xpos", "feats")]
    return Parsed(tags[0], tags[1], tags[2], tuple(heads), tuple(relations))


def parse_all(model: Any, batches: Batches, examples: Sequence[Example], labels: Labels) -> List[Parsed]:
    """Parse sentences by their gold words, with a network of torch."""
    import torch

    model.eval()
    order = sorted(range(len(examples)), key=lambda n: batches.length(examples[n]))
    found: Dict[int, Parsed] = {}
    with torch.inference_mode():
        for start in range(0, len(order), 64):
            part = order[start : start + 64]
            tensors = batches.batch([examples[n] for n in part])
            scores = model(tensors["numbers"], tensors["shapes"], tensors["pool"], tensors["bias"])
            arrays = {name: value.float().cpu().numpy() for name, value in scores.items()}
            for row, n in enumerate(part):
                count = len(examples[n].form)
                own = {name: value[row, :count] for name, value in arrays.items()}
                own["arcs"], own["relations"] = own["arcs"][:, : count + 1], own["relations"][:, : count + 1]
                found[n] = decoded(own, labels)
    return [found[n] for n in range(len(examples))]


def figures(examples: Sequence[Example], parsed: Sequence[Parsed]) -> Dict[str, float]:
    """Return percentages of right tags, heads and relations, and of whole trees."""
    right: Dict[str, int] = defaultdict(int)
    words = 0
    for gold, found in zip(examples, parsed):
        words += len(gold.form)
        for kind in ("upos", "xpos", "feats"):
            right[kind] += sum(a == b for a, b in zip(getattr(gold, kind), getattr(found, kind)))
        heads = [a == b for a, b in zip(gold.head, found.head)]
        both = [same and a == b for same, a, b in zip(heads, gold.deprel, found.deprel)]
        right["uas"] += sum(heads)
        right["las"] += sum(both)
        right["tree"] += all(both)
    result = {kind: 100.0 * right[kind] / max(1, words) for kind in ("upos", "xpos", "feats", "uas", "las")}
    result["tree"] = 100.0 * right["tree"] / max(1, len(examples))
    return result


def by_construction(examples: Sequence[Example], parsed: Sequence[Parsed]) -> Dict[str, float]:
    """Return the percentage of whole trees that are right, for each source."""
    groups: Dict[str, List[int]] = defaultdict(list)
    for number, one in enumerate(examples):
        groups[one.source].append(number)
    return {
        source: figures([examples[n] for n in rows], [parsed[n] for n in rows])["tree"]
        for source, rows in sorted(groups.items())
    }


Scorer = Callable[[Sequence[Example]], List[Parsed]]
