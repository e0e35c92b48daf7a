"""Writes the figures of ``score --json`` into the model card, between two marks."""

import json
from pathlib import Path
from typing import Dict, List, Mapping, Tuple

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


def differences(card: Path, figures: Path, most: float) -> List[str]:
    """Return the figures that differ by more than some points from those of a card; times are not compared.

    Args:
        card: the model card
        figures: of ``score --json``
        most: the allowed difference, in percent points
    Raises:
        TrainingError: a file is missing, or the two have no figure in common
    """
    for path in (card, figures):
        if not path.is_file():
            raise TrainingError(f"{path}: no such file")
    found: Mapping[str, Mapping[str, float]] = json.loads(figures.read_text(encoding="utf-8"))
    compared, different = 0, []
    for (title, name), before in _of_card(card.read_text(encoding="utf-8")).items():
        now = found.get(title, {}).get(name)
        if now is None or ("percent" not in title and title not in (RAW, GOLD)):
            continue
        compared += 1
        # Figures of a card are rounded.
        if abs(now - before) > most + 0.05:
            different.append(f"{title}, {name}: {now:.2f}, and {before:.2f} in the card")
    if not compared:
        raise TrainingError(f"{figures} and {card} have no figure in common")
    return different


def _of_card(text: str) -> Dict[Tuple[str, str], float]:
    """Return the figures between the marks of a card, by title and name."""
    figures: Dict[Tuple[str, str], float] = {}
    title = ""
    for line in text.partition(BEGIN)[2].partition(END)[0].splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if len(cells) == 4 and cells[0] in PUBLISHED:
            for column, of in ((1, RAW), (2, GOLD)):
                if cells[column] != "-":
                    figures[of, cells[0]] = float(cells[column])
        elif len(cells) == 2 and not cells[1]:
            title = cells[0]
        elif len(cells) == 2 and title and not cells[0].startswith("---"):
            figures[title, cells[0]] = float(cells[1])
    return figures


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
