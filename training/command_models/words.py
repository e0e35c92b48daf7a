"""Closed-class words with their analysis in UD_English-EWT, and inflection."""

from typing import Dict, Optional, Tuple

from .trees import Node

ADV, INTJ = "ADV", "INTJ"

# form -> (lemma, upos, xpos, features); the key may carry "/CLASS" where one form has several readings.
_TABLE: Dict[str, Tuple[str, str, str, str]] = {
    "the": ("the", "DET", "DT", "Definite=Def|PronType=Art"),
    "a": ("a", "DET", "DT", "Definite=Ind|PronType=Art"),
    "an": ("a", "DET", "DT", "Definite=Ind|PronType=Art"),
    "this": ("this", "DET", "DT", "Number=Sing|PronType=Dem"),
    "that": ("that", "DET", "DT", "Number=Sing|PronType=Dem"),
    "these": ("this", "DET", "DT", "Number=Plur|PronType=Dem"),
    "those": ("that", "DET", "DT", "Number=Plur|PronType=Dem"),
    "this/PRON": ("this", "PRON", "DT", "Number=Sing|PronType=Dem"),
    "that/PRON": ("that", "PRON", "DT", "Number=Sing|PronType=Dem"),
    "these/PRON": ("this", "PRON", "DT", "Number=Plur|PronType=Dem"),
    "those/PRON": ("that", "PRON", "DT", "Number=Plur|PronType=Dem"),
    "that/REL": ("that", "PRON", "WDT", "PronType=Rel"),
    "which": ("which", "PRON", "WDT", "PronType=Rel"),
    "which/DET": ("which", "DET", "WDT", "PronType=Int"),
    "who": ("who", "PRON", "WP", "PronType=Int"),
    "what": ("what", "PRON", "WP", "PronType=Int"),
    "what/DET": ("what", "DET", "WDT", "PronType=Int"),
    "where": ("where", "ADV", "WRB", "PronType=Int"),
    "when": ("when", "ADV", "WRB", "PronType=Int"),
    "how": ("how", "ADV", "WRB", "PronType=Int"),
    "my": ("my", "PRON", "PRP$", "Case=Gen|Number=Sing|Person=1|Poss=Yes|PronType=Prs"),
    "your": ("your", "PRON", "PRP$", "Case=Gen|Person=2|Poss=Yes|PronType=Prs"),
    "his": ("his", "PRON", "PRP$", "Case=Gen|Gender=Masc|Number=Sing|Person=3|Poss=Yes|PronType=Prs"),
    "her/POSS": ("her", "PRON", "PRP$", "Case=Gen|Gender=Fem|Number=Sing|Person=3|Poss=Yes|PronType=Prs"),
    "our": ("our", "PRON", "PRP$", "Case=Gen|Number=Plur|Person=1|Poss=Yes|PronType=Prs"),
    "their": ("their", "PRON", "PRP$", "Case=Gen|Number=Plur|Person=3|Poss=Yes|PronType=Prs"),
    "it": ("it", "PRON", "PRP", "Case=Acc|Gender=Neut|Number=Sing|Person=3|PronType=Prs"),
    "it/NOM": ("it", "PRON", "PRP", "Case=Nom|Gender=Neut|Number=Sing|Person=3|PronType=Prs"),
    "them": ("they", "PRON", "PRP", "Case=Acc|Number=Plur|Person=3|PronType=Prs"),
    "me": ("I", "PRON", "PRP", "Case=Acc|Number=Sing|Person=1|PronType=Prs"),
    "us": ("we", "PRON", "PRP", "Case=Acc|Number=Plur|Person=1|PronType=Prs"),
    "him": ("he", "PRON", "PRP", "Case=Acc|Gender=Masc|Number=Sing|Person=3|PronType=Prs"),
    "her": ("she", "PRON", "PRP", "Case=Acc|Gender=Fem|Number=Sing|Person=3|PronType=Prs"),
    "you": ("you", "PRON", "PRP", "Case=Nom|Person=2|PronType=Prs"),
    "you/ACC": ("you", "PRON", "PRP", "Case=Acc|Person=2|PronType=Prs"),
    "I": ("I", "PRON", "PRP", "Case=Nom|Number=Sing|Person=1|PronType=Prs"),
    "we": ("we", "PRON", "PRP", "Case=Nom|Number=Plur|Person=1|PronType=Prs"),
    "he": ("he", "PRON", "PRP", "Case=Nom|Gender=Masc|Number=Sing|Person=3|PronType=Prs"),
    "she": ("she", "PRON", "PRP", "Case=Nom|Gender=Fem|Number=Sing|Person=3|PronType=Prs"),
    "yourself": ("yourself", "PRON", "PRP", "Case=Acc|Number=Sing|Person=2|PronType=Prs|Reflex=Yes"),
    "everything": ("everything", "PRON", "NN", "Number=Sing|PronType=Tot"),
    "everyone": ("everyone", "PRON", "NN", "Number=Sing|PronType=Tot"),
    "something": ("something", "PRON", "NN", "Number=Sing|PronType=Ind"),
    "someone": ("someone", "PRON", "NN", "Number=Sing|PronType=Ind"),
    "anything": ("anything", "PRON", "NN", "Number=Sing|PronType=Ind"),
    "all": ("all", "DET", "DT", "PronType=Tot"),
    "all/PDT": ("all", "DET", "PDT", "PronType=Tot"),
    "half": ("half", "DET", "PDT", "NumForm=Word|NumType=Frac|PronType=Ind"),
    "both": ("both", "DET", "DT", "PronType=Tot"),
    "some": ("some", "DET", "DT", "PronType=Ind"),
    "any": ("any", "DET", "DT", "PronType=Ind"),
    "every": ("every", "DET", "DT", "PronType=Tot"),
    "each": ("each", "DET", "DT", "PronType=Tot"),
    "another": ("another", "DET", "DT", "PronType=Ind"),
    "there/EX": ("there", "PRON", "EX", "_"),
    "please": ("please", "INTJ", "UH", "_"),
    "to": ("to", "PART", "TO", "_"),
    "not": ("not", "PART", "RB", "Polarity=Neg"),
    "n't": ("not", "PART", "RB", "Polarity=Neg"),
    "'s": ("'s", "PART", "POS", "_"),
    "and": ("and", "CCONJ", "CC", "_"),
    "or": ("or", "CCONJ", "CC", "_"),
    "but": ("but", "CCONJ", "CC", "_"),
    "if": ("if", "SCONJ", "IN", "_"),
    "whether": ("whether", "SCONJ", "IN", "_"),
    "that/SCONJ": ("that", "SCONJ", "IN", "_"),
    "because": ("because", "SCONJ", "IN", "_"),
    "until/SCONJ": ("until", "SCONJ", "IN", "_"),
    "before/SCONJ": ("before", "SCONJ", "IN", "_"),
    "after/SCONJ": ("after", "SCONJ", "IN", "_"),
    "while": ("while", "SCONJ", "IN", "_"),
    "by/SCONJ": ("by", "SCONJ", "IN", "_"),
    "so": ("so", "ADV", "RB", "_"),
    "do": ("do", "AUX", "VB", "Mood=Imp|VerbForm=Fin"),
    "do/Q": ("do", "AUX", "VBP", "Mood=Ind|Number=Sing|Person=2|Tense=Pres|VerbForm=Fin"),
    "is": ("be", "AUX", "VBZ", "Mood=Ind|Number=Sing|Person=3|Tense=Pres|VerbForm=Fin"),
    "'s/AUX": ("be", "AUX", "VBZ", "Mood=Ind|Number=Sing|Person=3|Tense=Pres|VerbForm=Fin"),
    "are": ("be", "AUX", "VBP", "Mood=Ind|Number=Plur|Person=3|Tense=Pres|VerbForm=Fin"),
    "are/2": ("be", "AUX", "VBP", "Mood=Ind|Number=Sing|Person=2|Tense=Pres|VerbForm=Fin"),
    "am": ("be", "AUX", "VBP", "Mood=Ind|Number=Sing|Person=1|Tense=Pres|VerbForm=Fin"),
    "'m": ("be", "AUX", "VBP", "Mood=Ind|Number=Sing|Person=1|Tense=Pres|VerbForm=Fin"),
    "is/VERB": ("be", "VERB", "VBZ", "Mood=Ind|Number=Sing|Person=3|Tense=Pres|VerbForm=Fin"),
    "are/VERB": ("be", "VERB", "VBP", "Mood=Ind|Number=Plur|Person=3|Tense=Pres|VerbForm=Fin"),
    "'d": ("would", "AUX", "MD", "VerbForm=Fin"),
    "then": ("then", "ADV", "RB", "PronType=Dem"),
    "here": ("here", "ADV", "RB", "PronType=Dem"),
    "there": ("there", "ADV", "RB", "PronType=Dem"),
    "now": ("now", "ADV", "RB", "PronType=Dem"),
    "never": ("never", "ADV", "RB", "PronType=Neg"),
    "once": ("once", "ADV", "RB", "NumForm=Word|NumType=Mult"),
    "twice": ("twice", "ADV", "RB", "NumForm=Word|NumType=Mult"),
    "yes": ("yes", "INTJ", "UH", "Polarity=Pos"),
    "no": ("no", "INTJ", "UH", "Polarity=Neg"),
    "thanks": ("thanks", "NOUN", "NN", "Number=Sing"),
    "more": ("more", "ADJ", "JJR", "Degree=Cmp"),
    "few": ("few", "ADJ", "JJ", "Degree=Pos"),
}

_IRREGULAR_PLURAL: Dict[str, str] = {
    "foot": "feet",
    "man": "men",
    "woman": "women",
    "child": "children",
    "person": "people",
    "knife": "knives",
    "shelf": "shelves",
    "leaf": "leaves",
    "loaf": "loaves",
    "mouse": "mice",
    "half": "halves",
    "tooth": "teeth",
    "scarf": "scarves",
    "wife": "wives",
}
_IRREGULAR_PAST: Dict[str, Tuple[str, str]] = {
    "put": ("put", "put"),
    "keep": ("kept", "kept"),
    "leave": ("left", "left"),
    "make": ("made", "made"),
    "take": ("took", "taken"),
    "give": ("gave", "given"),
    "find": ("found", "found"),
    "see": ("saw", "seen"),
    "bring": ("brought", "brought"),
    "hang": ("hung", "hung"),
    "set": ("set", "set"),
    "lie": ("lay", "lain"),
    "stand": ("stood", "stood"),
    "buy": ("bought", "bought"),
    "break": ("broke", "broken"),
    "write": ("wrote", "written"),
    "wear": ("wore", "worn"),
    "hold": ("held", "held"),
    "cut": ("cut", "cut"),
    "shut": ("shut", "shut"),
    "wash": ("washed", "washed"),
    "sit": ("sat", "sat"),
    "say": ("said", "said"),
    "tell": ("told", "told"),
    "lose": ("lost", "lost"),
    "get": ("got", "got"),
    "turn": ("turned", "turned"),
    "come": ("came", "come"),
    "go": ("went", "gone"),
    "hide": ("hid", "hidden"),
}
_DOUBLING = {
    "stop",
    "drop",
    "grab",
    "scrub",
    "mop",
    "wrap",
    "chop",
    "hop",
    "step",
    "grip",
    "spin",
    "dip",
    "tap",
    "hug",
    "put",
    "set",
    "cut",
    "shut",
    "get",
    "sit",
    "run",
    "plug",
    "unplug",
    "clap",
    "stir",
    "pat",
    "hit",
    "zip",
    "dig",
    "nod",
    "skip",
    "swim",
    "trim",
    "peg",
    "tag",
    "wag",
    "pin",
    "map",
    "scan",
    "rub",
    "lug",
    "flip",
    "snap",
    "trot",
}
VOWELS = "aeiou"


def word(key: str) -> Node:
    """A closed-class word by its key in the table (``that/REL``)."""
    lemma, upos, xpos, feats = _TABLE[key]
    return Node(key.split("/")[0], lemma, upos, xpos, feats)


def adposition(form: str) -> Node:
    return Node(form, form, "ADP", "IN")


def particle(form: str) -> Node:
    return Node(form, form, "ADP", "RP")


def adverb(form: str) -> Node:
    """An adverb; those with features of their own come from the table."""
    if form in _TABLE and _TABLE[form][1] == ADV:
        return word(form)
    return Node(form, form, ADV, "RB")


def interjection(form: str) -> Node:
    if form in _TABLE and _TABLE[form][1] == INTJ:
        return word(form)
    return Node(form, form, INTJ, "UH")


def adjective(form: str) -> Node:
    return Node(form, form, "ADJ", "JJ", "Degree=Pos")


def modal(form: str) -> Node:
    return Node(form, form, "AUX", "MD", "VerbForm=Fin")


def noun(lemma: str, many: bool = False) -> Node:
    if many:
        return Node(plural(lemma), lemma, "NOUN", "NNS", "Number=Plur")
    return Node(lemma, lemma, "NOUN", "NN", "Number=Sing")


def name(form: str) -> Node:
    return Node(form, form, "PROPN", "NNP", "Number=Sing")


def number(form: str) -> Node:
    """A number in digits or as one word."""
    if form[0].isdigit():
        kind = "Frac" if "." in form else "Card"
        return Node(form, form, "NUM", "CD", "NumForm=Digit|NumType=" + kind)
    return Node(form, form, "NUM", "CD", "NumForm=Word|NumType=Card")


def comma() -> Node:
    return Node(",", ",", "PUNCT", ",", tight=True)


def imperative(lemma: str) -> Node:
    return Node(lemma, lemma, "VERB", "VB", "Mood=Imp|VerbForm=Fin")


def infinitive(lemma: str) -> Node:
    return Node(lemma, lemma, "VERB", "VB", "VerbForm=Inf")


def present(lemma: str, person: int = 1) -> Node:
    """Present tense: 1st and 2nd person singular, or 3rd singular with its ending."""
    if person == 3:
        return Node(third(lemma), lemma, "VERB", "VBZ", "Mood=Ind|Number=Sing|Person=3|Tense=Pres|VerbForm=Fin")
    feats = f"Mood=Ind|Number=Sing|Person={person}|Tense=Pres|VerbForm=Fin"
    return Node(lemma, lemma, "VERB", "VBP", feats)


def past(lemma: str) -> Node:
    feats = "Mood=Ind|Number=Sing|Person=1|Tense=Past|VerbForm=Fin"
    return Node(_past_forms(lemma)[0], lemma, "VERB", "VBD", feats)


def participle(lemma: str) -> Node:
    """Past participle in a passive sense."""
    return Node(_past_forms(lemma)[1], lemma, "VERB", "VBN", "Tense=Past|VerbForm=Part|Voice=Pass")


def gerund(lemma: str, feats: str = "VerbForm=Ger") -> Node:
    return Node(ing(lemma), lemma, "VERB", "VBG", feats)


def _sibilant(stem: str) -> bool:
    return stem.endswith(("s", "x", "z", "ch", "sh"))


def plural(lemma: str) -> str:
    if lemma in _IRREGULAR_PLURAL:
        return _IRREGULAR_PLURAL[lemma]
    if _sibilant(lemma) or lemma in ("tomato", "potato", "mango"):
        return lemma + "es"
    if lemma.endswith("y") and lemma[-2:-1] not in VOWELS:
        return lemma[:-1] + "ies"
    return lemma + "s"


def third(lemma: str) -> str:
    if _sibilant(lemma) or lemma.endswith("o"):
        return lemma + "es"
    if lemma.endswith("y") and lemma[-2:-1] not in VOWELS:
        return lemma[:-1] + "ies"
    return lemma + "s"


def ing(lemma: str) -> str:
    if lemma in _DOUBLING:
        return lemma + lemma[-1] + "ing"
    if lemma.endswith("ie"):
        return lemma[:-2] + "ying"
    if lemma.endswith("e") and not lemma.endswith(("ee", "oe", "ye")):
        return lemma[:-1] + "ing"
    return lemma + "ing"


def _past_forms(lemma: str) -> Tuple[str, str]:
    if lemma in _IRREGULAR_PAST:
        return _IRREGULAR_PAST[lemma]
    if lemma in _DOUBLING:
        form = lemma + lemma[-1] + "ed"
    elif lemma.endswith("e"):
        form = lemma + "d"
    elif lemma.endswith("y") and lemma[-2:-1] not in VOWELS:
        form = lemma[:-1] + "ied"
    else:
        form = lemma + "ed"
    return form, form


def article(following: str, definite: bool) -> Optional[Node]:
    """``the``, or ``a``/``an`` by the sound that follows (by its letter: good enough for the lexicon)."""
    if definite:
        return word("the")
    return word("an" if following[:1].lower() in VOWELS else "a")
