"""Language, units and brightness of one screen."""

from __future__ import annotations

from playwright.sync_api import Browser, expect

from tests.server.real_service import RealService
from tests.web.tablet import tablet


def test_the_console_speaks_german_with_a_decimal_comma_in_grams_and_keeps_it(service: RealService, browser: Browser):
    with tablet(browser, service) as at:
        at.open()
        at.sign_in()
        mass = at.page.get_by_label("Mass")
        expect(mass).to_have_value("2.783")
        at.tap(at.page.get_by_role("link", name="Settings"))
        at.tap(at.page.get_by_text("Deutsch"))
        at.page.reload()
        expect(at.page.get_by_role("heading", name="Einstellungen")).to_be_visible()
        at.tap(at.page.get_by_role("link", name="Lauf", exact=True))
        german = at.page.get_by_label("Masse")
        expect(german).to_have_value("2,783")
        plan = at.page.get_by_role("button", name="planen")
        for text, readable in (("1,5", True), ("1.5", True), ("1.234,5", False), ("0", False), ("-1", False), ("", False)):
            german.fill(text)
            expect(plan).to_be_enabled(enabled=readable)
        at.tap(at.page.get_by_role("link", name="Einstellungen"))
        at.tap(at.page.get_by_text("g, mm"))
        at.tap(at.page.get_by_role("link", name="Lauf", exact=True))
        expect(german).to_have_value("2783")
        assert at.complaints == []


def test_a_theme_that_is_chosen_goes_before_the_devices(service: RealService, browser: Browser):
    with tablet(browser, service, color_scheme="light") as at:
        at.open()
        light = at.page.evaluate("getComputedStyle(document.body).backgroundColor")
        at.sign_in()
        at.tap(at.page.get_by_role("link", name="Settings"))
        at.tap(at.page.get_by_text("Dark"))
        assert at.page.evaluate("getComputedStyle(document.body).backgroundColor") != light


def test_a_wrong_password_is_refused_in_words(service: RealService, browser: Browser):
    with tablet(browser, service) as at:
        at.open()
        at.page.get_by_label("Name").fill("nobody")
        at.page.get_by_label("Password").fill("wrong")
        at.press("Sign in")
        expect(at.page.get_by_role("alert")).to_contain_text("not right")
