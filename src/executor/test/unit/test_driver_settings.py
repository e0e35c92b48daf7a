"""Settings of other nodes: reading, conflicts, types, the record."""

import json

import pytest

from executor.driver_settings import (
    HeldSetting,
    Setting,
    SettingsError,
    check_needs,
    differs,
    fit_value,
    from_record,
    read_needs,
    to_record,
)

EXPOSURE = Setting(node="/camera", name="exposure", value=20)


def test_needs_are_read():
    assert read_needs([{"node": "/camera", "settings": {"exposure": 20}}], server="photo") == (EXPOSURE,)
    assert read_needs(None, server="photo") == ()
    assert read_needs([], server="photo") == ()


@pytest.mark.parametrize(
    "found,part",
    [
        ({"/camera": {"exposure": 20}}, "a list"),
        ([1], "expected node"),
        ([{"node": "/camera"}], "expected node"),
        ([{"node": "/camera", "settings": 3}], "expected node"),
        ([{"node": "", "settings": {}}], "expected node"),
        ([{"node": "/camera", "settings": {}, "more": 1}], "more"),
        ([{"node": "/camera", "settings": {"exposure": [1]}}], "/camera, exposure"),
        ([{"node": "/camera", "settings": {"exposure": float("nan")}}], "exposure"),
        ([{"node": "/camera", "settings": {"exposure": None}}], "exposure"),
    ],
)
def test_wrong_needs_are_refused_with_their_place(found, part):
    with pytest.raises(SettingsError, match=f"photo.*{part}"):
        read_needs(found, server="photo")


def held(value, owner="other step"):
    return {EXPOSURE.place: HeldSetting(setting=Setting("/camera", "exposure", value), former=5, owners=(owner,))}


def test_same_value_can_be_shared():
    check_needs([EXPOSURE], held(20))


def test_conflict_with_another_step_names_it():
    with pytest.raises(SettingsError, match="exposure of /camera must be 20, but other step needs 30"):
        check_needs([EXPOSURE], held(30))


def test_conflict_within_one_step():
    with pytest.raises(SettingsError, match="20 and 30 at once"):
        check_needs([EXPOSURE, Setting("/camera", "exposure", 30)], {})


@pytest.mark.parametrize(
    "value,current,fitted", [(20, 1.5, 20.0), (20.0, 3, 20), (True, False, True), ("a", "b", "a"), (2.5, 1.0, 2.5)]
)
def test_value_takes_the_type_of_the_node(value, current, fitted):
    result = fit_value(Setting("/n", "s", value), current)
    assert result == fitted and type(result) is type(fitted)


@pytest.mark.parametrize("value,current", [(2.5, 3), ("fast", 3), (1, True), (True, 1), (3, "a"), (True, "a")])
def test_value_of_another_type_is_refused(value, current):
    with pytest.raises(SettingsError, match="takes"):
        fit_value(Setting("/n", "s", value), current)


def test_record_survives_json():
    record = json.loads(json.dumps(to_record(held(20))))
    assert from_record(record) == (Setting("/camera", "exposure", 5),)
    assert from_record(None) == ()


@pytest.mark.parametrize("found", [3, [3], [{"node": "/camera"}]])
def test_record_of_another_shape_is_refused(found):
    with pytest.raises(SettingsError):
        from_record(found)


def test_values_that_a_node_changed_are_seen():
    assert differs(20, 10) and differs(2.0, 1.0) and differs(2.0, None)
    assert not differs(0.1 + 0.2, 0.3) and not differs("a", "a")
