"""Numbers and measures are read as people say them."""

import math
import random
from typing import List

import pytest

from spoken_quantities import (
    QuantityError,
    find_number,
    find_unit,
    find_whole_number,
    number_words,
    parse_measure,
    parse_number,
    unit_words,
    units_of,
)

ONES = (
    "zero one two three four five six seven eight nine ten eleven twelve thirteen fourteen fifteen sixteen seventeen "
    "eighteen nineteen"
).split()
TENS = "zero ten twenty thirty forty fifty sixty seventy eighty ninety".split()


def in_words(number: int) -> str:
    """Return the English words of a number below 10,000."""
    words: List[str] = []
    if number >= 1000:
        words += [ONES[number // 1000], "thousand"]
    if number % 1000 >= 100:
        words += [ONES[number % 1000 // 100], "hundred"]
    rest = number % 100
    if rest and words:
        words.append("and")
    if rest >= 20:
        words.append(TENS[rest // 10] + ("-" + ONES[rest % 10] if rest % 10 else ""))
    elif rest or not words:
        words.append(ONES[rest])
    return " ".join(words)


def test_every_number_below_ten_thousand_in_words() -> None:
    assert all(parse_number(in_words(number)) == number for number in range(10000))


@pytest.mark.parametrize(
    "text, number",
    [
        ("120", 120),
        ("-2", -2),
        ("+3", 3),
        ("3.5", 3.5),
        (".5", 0.5),
        ("1,000", 1000),
        ("minus two", -2),
        ("negative 5", -5),
        ("one eighty", 180),
        ("three sixty", 360),
        ("one twenty five", 125),
        ("two forty-five", 245),
        ("a couple of", 2),
        ("a couple", 2),
        ("a few", 3),
        ("a", 1),
        ("an", 1),
        ("half", 0.5),
        ("half a", 0.5),
        ("a half", 0.5),
        ("two and a half", 2.5),
        ("a quarter", 0.25),
        ("three quarters", 0.75),
        ("a dozen", 12),
        ("a hundred", 100),
        ("two point five", 2.5),
        ("one hundred twenty", 120),
        ("about three", 3),
        ("1/2", 0.5),
        ("one thousand two hundred and six", 1206),
        ("2 hundred", 200),
        ("twenty-one", 21),
        ("one and a quarter", 1.25),
        ("two and half", 2.5),
        ("half a dozen", 6),
        ("minus half", -0.5),
        ("\u22122", -2),
        ("- 2", -2),
        ("twelve hundred", 1200),
        ("hundred thousand", 100000),
        ("2 hundred and 50", 250),
        ("1 / 2", 0.5),
        ("three quarter", 0.75),
        ("three-quarters", 0.75),
        ("one-half", 0.5),
        ("3 1/2", 3.5),
        ("3-1/2", 3.5),
        ("3 and 1/2", 3.5),
        ("\u00bd", 0.5),
        ("3\u00bd", 3.5),
        ("nine and three quarters", 9.75),
        ("two-and-a-half", 2.5),
        ("2-and-a-half", 2.5),
        ("two thirds", 2 / 3),
        ("five eighths", 0.625),
        ("two hundred and twenty-five", 225),
        ("one oh five", 105),
        ("one-eighty", 180),
        ("one ten", 110),
        ("three ten", 310),
        ("four twenty", 420),
        ("1 oh 5", 105),
        ("9/8", 1.125),
        ("10/16", 0.625),
        ("minus point five", -0.5),
        ("about -6", -6),
        ("1e1", 10),
    ],
)
def test_parse_number(text: str, number: float) -> None:
    assert parse_number(text) == pytest.approx(number)
    assert find_number(text) == parse_number(text)


@pytest.mark.parametrize(
    ("text", "number"), [("twelve", 12), ("-3", -3), ("2.5", None), ("many", None), ("1e999", None)]
)
def test_whole_numbers(text, number):
    assert find_whole_number(text) == number


@pytest.mark.parametrize(
    "text",
    [
        "",
        "feet",
        "two mugs",
        "and",
        "three and",
        "one two",
        "ten five",
        "-",
        "point",
        "e",
        "twenty ten",
        "nan",
        "inf",
        "infinity",
        "1e",
        "--2x",
        "--2",
        "100-50",
        "20-3",
        "100 50",
        "1 80",
        "zero eighty",
        "a eighty",
        "one hundred two hundred",
        "two thousand three thousand",
        "one dozen two",
        "twenty third",
        "a / b",
        "and / or",
        "two point \u00b2",
        "e5",
        "1e5e5",
        "1,5",
        "1000,000",
        "minus minus two",
        "oh",
        "third",
        "10/15",
        "five ten",
        "five-ten",
        "two-ten",
        "four ten",
        "ten fifty",
        "twenty zero",
        "zero oh five",
        "ten oh five",
        "one oh oh five",
        "one hundred hundred",
        "one hundred and 100",
        "3 0/2",
        "3 2/2",
        "3 10/15",
        "many 1/2",
        "10/8",
        "three-fifty",
        "twenty quarter",
        "twenty three quarters",
        "one hundred and three quarters",
        "a dozen and a half",
        "half and half",
        "1.5 and a half",
        "two thousand 5000",
        "1.5 point 5",
    ],
)
def test_other_words_are_refused_as_numbers(text: str) -> None:
    with pytest.raises(QuantityError) as raised:
        parse_number(text)
    assert raised.value.code == "NOT_A_NUMBER" and find_number(text) is None


@pytest.mark.parametrize("text", ["1e400", "-1e999", "1/0", "10/0"])
def test_infinite_number_is_refused(text: str) -> None:
    with pytest.raises(QuantityError) as raised:
        parse_number(text)
    assert raised.value.code == "NOT_FINITE" and find_number(text) is None


@pytest.mark.parametrize(
    "text, quantity, si_amount, unit",
    [
        ("3 feet", "length", 0.9144, "foot"),
        ("one metre", "length", 1.0, "metre"),
        ("half a metre", "length", 0.5, "metre"),
        ("a couple of metres", "length", 2.0, "metre"),
        ("minus two degrees", "angle", math.radians(-2), "degree"),
        ("ninety degrees", "angle", math.pi / 2, "degree"),
        ("10cm", "length", 0.1, "centimetre"),
        ("90°", "angle", math.pi / 2, "degree"),
        ("90º", "angle", math.pi / 2, "degree"),
        ("90 ˚", "angle", math.pi / 2, "degree"),
        ("９０ degrees", "angle", math.pi / 2, "degree"),
        ("２．５ｍ", "length", 2.5, "metre"),
        ("10cms", "length", 0.1, "centimetre"),
        ("2mtrs", "length", 2.0, "metre"),
        ("500msec", "duration", 0.5, "millisecond"),
        ("2 radians", "angle", 2.0, "radian"),
        ("two yards", "length", 1.8288, "yard"),
        ("half an hour", "duration", 1800.0, "hour"),
        ("a quarter of a turn", "angle", math.pi / 2, "turn"),
        ("5 seconds", "duration", 5.0, "second"),
        ("a foot", "length", 0.3048, "foot"),
        ("two and a half metres", "length", 2.5, "metre"),
        ("-3 m", "length", -3.0, "metre"),
        ("minus a metre", "length", -1.0, "metre"),
        ("3 1/2 feet", "length", 1.0668, "foot"),
        ("two more metres", "length", 2.0, "metre"),
        ("a full turn", "angle", 2 * math.pi, "turn"),
        ("three-quarters of a turn", "angle", 1.5 * math.pi, "turn"),
        ("90-degree", "angle", math.pi / 2, "degree"),
    ],
)
def test_parse_measure(text: str, quantity: str, si_amount: float, unit: str) -> None:
    measure = parse_measure(text, quantity=quantity)
    assert measure.si_amount == pytest.approx(si_amount)
    assert (measure.unit, measure.quantity) == (unit, quantity)


@pytest.mark.parametrize(
    "text, amount, unit, si_amount",
    [
        ("5 feet 6 inches", 5.5, "foot", 1.6764),
        ("five feet and six inches", 5.5, "foot", 1.6764),
        ("five foot six", 5.5, "foot", 1.6764),
        ("minus five foot six", -5.5, "foot", -1.6764),
        ("5'6\"", 5.5, "foot", 1.6764),
        ("5ft 6in", 5.5, "foot", 1.6764),
        ("two metres fifty", 2.5, "metre", 2.5),
        ("2 m 50 cm", 2.5, "metre", 2.5),
        ("two metres and a half", 2.5, "metre", 2.5),
        ("two metres and fifty centimetres", 2.5, "metre", 2.5),
        ("one kilometre five hundred", 1.5, "kilometre", 1500.0),
        ("a yard two feet six inches", 1 + 2.5 / 3, "yard", 1.6764),
        ("an hour and a half", 1.5, "hour", 5400.0),
        ("one hour thirty", 1.5, "hour", 5400.0),
        ("1 hour 2 minutes 3 seconds", 3723 / 3600, "hour", 3723.0),
        ("two minutes and ten seconds", 130 / 60, "minute", 130.0),
        ("three turns and ninety degrees", 3.25, "turn", 6.5 * math.pi),
    ],
)
def test_measure_in_several_units_is_their_sum(text: str, amount: float, unit: str, si_amount: float) -> None:
    measure = parse_measure(text)
    assert (measure.amount, measure.si_amount) == (pytest.approx(amount), pytest.approx(si_amount))
    assert measure.unit == unit


@pytest.mark.parametrize(
    "text",
    [
        "5 feet 13 inches",
        "five foot thirteen",
        "6 inches 5 feet",
        "5 feet 6 feet",
        "5 feet 6 degrees",
        "two metres five",
        "2.5 metres 50",
        "5 feet minus 6 inches",
        "5 feet -6 inches",
        "5 feet and six",
        "1 metre in",
        "5 degrees 6",
        "two metres turn ninety degrees",
        "5 feet 1e400 inches",
    ],
)
def test_measures_that_do_not_add_up_are_refused(text: str) -> None:
    with pytest.raises(QuantityError):
        parse_measure(text)


def test_sum_is_checked_for_its_quantity() -> None:
    with pytest.raises(QuantityError) as raised:
        parse_measure("5 feet 6 inches", quantity="angle")
    assert raised.value.code == "WRONG_QUANTITY"


def test_bare_number_takes_the_default_unit() -> None:
    assert parse_measure("one eighty", quantity="angle", default_unit="degrees").si_amount == pytest.approx(math.pi)


@pytest.mark.parametrize(
    "text, quantity, code",
    [
        ("3 feet", "angle", "WRONG_QUANTITY"),
        ("3 parsecs", "length", "UNKNOWN_UNIT"),
        ("3", "length", "MISSING_UNIT"),
        ("1e400 degrees", "angle", "NOT_FINITE"),
        ("1e306 kilometres", "length", "NOT_FINITE"),
        ("", "length", "NOT_A_NUMBER"),
        ("the kitchen", "length", "NOT_A_NUMBER"),
        ("100-50 metres", "length", "NOT_A_NUMBER"),
        ("metres", "length", "NOT_A_NUMBER"),
        ("feet", "length", "NOT_A_NUMBER"),
    ],
)
def test_wrong_measure_is_refused(text: str, quantity: str, code: str) -> None:
    with pytest.raises(QuantityError) as raised:
        parse_measure(text, quantity=quantity)
    assert raised.value.code == code


@pytest.mark.parametrize("text, metres", [("metre", 1.0), ("foot", 0.3048)])
def test_unit_alone_in_the_singular_is_one_of_it(text: str, metres: float) -> None:
    assert parse_measure(text, quantity="length").si_amount == pytest.approx(metres)


@pytest.mark.parametrize("seed", range(5))
def test_any_text_is_a_finite_number_or_refused_with_a_reason(seed: int) -> None:
    chance = random.Random(seed)
    parts = list(number_words()) + [
        "a",
        "an",
        "and",
        "of",
        "point",
        "-",
        "/",
        "2",
        "50",
        "1e9",
        "\u00b2",
        "feet",
        "-3",
        "",
    ]
    for _ in range(2000):
        text = " ".join(chance.choice(parts) for _ in range(chance.randint(0, 6)))
        for read in (parse_number, lambda said: parse_measure(said).si_amount):
            try:
                assert math.isfinite(read(text)), f"{text!r}, seed {seed}"
            except QuantityError as error:
                assert error.code and str(error), f"{text!r}, seed {seed}"


def test_every_quantity_has_units_and_each_is_found_by_its_name() -> None:
    for quantity, names in (("angle", ("degree", "radian", "turn")), ("length", ("metre", "centimetre", "millimetre"))):
        assert units_of(quantity)[:3] == names
        assert {unit.quantity for name in units_of(quantity) for unit in [find_unit(name)] if unit} == {quantity}
    assert units_of("colour") == ()


def test_only_a_step_has_an_assumed_length() -> None:
    units = {word: find_unit(word) for word in unit_words()}
    assert [word for word, unit in units.items() if unit is not None and unit.is_assumed] == ["step", "steps"]
    assert parse_measure("two steps").si_amount == pytest.approx(1.0)
