"""What tests of pages share: a page in a browser, and nothing asked for outside it."""

import unittest

WIDE, PHONE = (1400, 1000), (390, 844)


def drawn(kind):
    """An expression: the first figure of a kind."""
    return f"document.querySelector('figure.{kind}')"


class PageCase(unittest.TestCase):
    browser = None
    pages = []

    def open(self, number=0, **how):
        self.browser.open(f"file://{self.pages[number]}", **how)

    def ask(self, expression):
        return self.browser.ask(expression)

    def see(self, kind):
        """Scrolls to the first figure of a kind, which is drawn then."""
        self.ask(f"{drawn(kind)}.scrollIntoView({{block: 'center', behavior: 'instant'}})")
        self.browser.wait(f"{drawn(kind)}.querySelector('svg .series')")

    def tearDown(self):
        self.assertEqual(self.browser.complaints, [])
        address = f"file://{self.pages[0].parent}"
        outside = [url for url in self.browser.requests if not url.startswith(("data:", "blob:", "about:", address[:12]))]
        self.assertEqual(outside, [], "the page asks for something outside itself")
