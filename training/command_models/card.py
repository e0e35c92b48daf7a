"""Writes the figures of ``score --json`` into the model card, between two marks."""

import json
from pathlib import Path
from typing import Dict, List, Mapping

from .errors import TrainingError

BEGIN, END = "<!-- figures: begin -->", "<!-- figures: end -->"
# Stanza's own English EWT models: v1.5.1 on UD 2.12, with character language model, from raw text
# (model performance page of its documentation, 2023)
PUBLISHED: Dict[str, float] = {
    "Tokens": 99.17, "Sentences": 89.16, "Words": 98.92, "UPOS": 96.20, "XPOS": 95.75, "UFeats": 96.39,
    "Lemmas": 96.63, "UAS": 88.90, "LAS": 86.77, "CLAS": 84.11, "MLAS": 80.27,
}  # fmt: skip
RAW, GOLD = "ewt test, raw text", "ewt test, gold words"


def section(figures: Mapping[str, Mapping[str, float]], manifest: Mapping[str, object]) -> str:
    """Return the figures as Markdown, in the order file sizes, treebank, commands, HuRIC, latency."""
    lines: List[str] = [BEGIN, ""]
    files = manifest.get("files")
    if isinstance(files, list):
        lines += ["| file | bytes | md5 |", "| --- | --- | --- |"]
        lines += [f"| {entry['path']} | {entry['bytes']} | {entry['md5']} |" for entry in files]
        lines += [f"| in all | {manifest.get('bytes')} | |", ""]
    if RAW in figures:
        lines += [
            "UD_English-EWT test, CoNLL 2018 evaluation (F1). Published: Stanza 1.5.1 on UD 2.12, with character",
            "language model, raw text.", "",
            "| metric | raw text | gold words | Stanza, published |", "| --- | --- | --- | --- |",
        ]  # fmt: skip
        for metric, published in PUBLISHED.items():
            gold = figures.get(GOLD, {}).get(metric)
            shown = f"{gold:.2f}" if gold is not None and metric not in ("Tokens", "Sentences", "Words") else "-"
            lines.append(f"| {metric} | {figures[RAW][metric]:.2f} | {shown} | {published:.2f} |")
        lines.append("")
    for title, found in figures.items():
        if title in (RAW, GOLD):
            continue
        lines += [f"| {title} | |", "| --- | --- |"]
        lines += [f"| {name} | {value:.1f} |" for name, value in found.items()] + [""]
    return "\n".join(lines + [END])


def update(card: Path, figures: Path, manifest: Path) -> None:
    """Replace the figures between the marks of the card.

    Raises TrainingError when a file or a mark is missing.
    """
    for path in (card, figures, manifest):
        if not path.is_file():
            raise TrainingError(f"{path}: no such file")
    text = card.read_text(encoding="utf-8")
    before, found, rest = text.partition(BEGIN)
    _, closed, after = rest.partition(END)
    if not found or not closed:
        raise TrainingError(f"{card}: expected the marks {BEGIN} and {END} around the figures")
    made = section(json.loads(figures.read_text(encoding="utf-8")), json.loads(manifest.read_text(encoding="utf-8")))
    card.write_text(before + made + after, encoding="utf-8")
