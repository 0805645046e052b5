"""What a drawing shows, read from its HTML."""

import re
from xml.etree import ElementTree

from param_tutorial.views.drawing.svg import AnimatedPicture, Animation


def drawn(picture: AnimatedPicture) -> ElementTree.Element:
    """Return an animated picture as it stands at the end, without its drawing for a narrow page."""
    return _still(picture, 'class', 'motion-narrow')


def drawn_narrow(picture: AnimatedPicture) -> ElementTree.Element:
    """Return an animated picture as it stands at the end on a narrow page."""
    return _still(picture, 'viewBox', '0 0 720')


def _still(picture: AnimatedPicture, attribute: str, unwanted: str) -> ElementTree.Element:
    root = ElementTree.fromstring(picture.html(Animation('one', is_still=True)))
    scene = root.find('div[@class="motion-scene"]')
    for drawing in list(scene):
        if drawing.get(attribute, '').startswith(unwanted):
            scene.remove(drawing)
    return root


def kinds(picture: AnimatedPicture) -> list[str]:
    """Return the classes of all parts, without their prefix."""
    return [part.get('class', '').replace('motion-', '') for part in drawn(picture).iter()]


def words(picture: AnimatedPicture) -> list[str]:
    """Return all texts that can be seen."""
    return [text for text in drawn(picture).itertext() if text.strip()]


def rests(markup: str) -> list[str]:
    """Return the places in which the moving parts end."""
    return re.findall(r'style="[^"]*?(transform:translate[^";]*)', markup)
