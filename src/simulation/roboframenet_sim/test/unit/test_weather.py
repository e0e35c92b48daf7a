"""It rains by itself, and at a word."""

from roboframenet_sim.weather import DRY_S, RAIN_S, Weather


def changes(weather: Weather, most_s: int) -> "list[tuple[int, bool]]":
    """Return when the weather changed, and to what."""
    found = []
    for second in range(1, most_s + 1):
        before = weather.is_raining
        weather.step(1.0)
        if weather.is_raining != before:
            found.append((second, weather.is_raining))
    return found


def test_dry_hours_and_showers_take_turns():
    found = changes(Weather(seed=1), 20_000)
    assert [is_raining for _, is_raining in found] == [index % 2 == 0 for index in range(len(found))]
    moments = [0, *(second for second, _ in found)]
    for index, (begin_s, end_s) in enumerate(zip(moments, moments[1:])):
        least_s, most_s = DRY_S if index % 2 == 0 else RAIN_S
        assert least_s <= end_s - begin_s <= most_s + 1.0


def test_the_same_seed_makes_the_same_weather():
    assert changes(Weather(seed=3), 9000) == changes(Weather(seed=3), 9000) != changes(Weather(seed=4), 9000)


def test_it_may_be_told_to_rain():
    weather = Weather()
    weather.change(is_raining=True)
    assert weather.is_raining
    weather.step(RAIN_S[1])
    assert not weather.is_raining
