"""What a drawing shows, read from its HTML."""

import re
from xml.etree import ElementTree

from param_tutorial.views.drawing.svg import AnimatedPicture, Animation


def drawn(picture: AnimatedPicture) -> ElementTree.Element:
    """Return an animated picture as it stands at the end, without its drawing for a narrow page."""
    root = ElementTree.fromstring(picture.html(Animation('one', is_still=True)))
    scene = root.find('div[@class="motion-scene"]')
    for narrow in scene.findall('svg[@class="motion-narrow"]'):
        scene.remove(narrow)
    return root


def parsed(picture) -> ElementTree.Element:
    """Return a picture that does not move."""
    return ElementTree.fromstring(picture._repr_html_())


def labels(picture) -> list[str]:
    """Return the texts of a picture that does not move."""
    return [text.text for text in parsed(picture).iter('text')]


def kinds(picture: AnimatedPicture) -> list[str]:
    """Return the classes of all parts, without their prefix."""
    return [part.get('class', '').replace('motion-', '') for part in drawn(picture).iter()]


def words(picture: AnimatedPicture) -> list[str]:
    """Return all texts that can be seen."""
    return [text for text in drawn(picture).itertext() if text.strip()]


def rests(markup: str) -> list[str]:
    """Return the places in which the moving parts end."""
    return re.findall(r'style="[^"]*?(transform:translate[^";]*)', markup)
