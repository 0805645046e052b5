"""Pictures on pages of all widths: no letter is too small to read, and none is cut off."""

import pytest

from param_tutorial.views.cart import cart_on_trip
from param_tutorial.views.drawing import driving, svg
from tests.views.test_svg import PICTURES

NARROW = {'ladder', 'layers', 'messages', 'number line', 'requests'}

# For each drawing that is seen: how large its smallest letters are in px, what is cut off, and whether it scrolls.
LOOK = '''name => {
  const scene = document.getElementById(name).querySelector('.motion-scene');
  const drawing = [...scene.children].find(each => getComputedStyle(each).display !== 'none');
  const frame = drawing.getBoundingClientRect();
  const scale = frame.width / drawing.viewBox.baseVal.width;
  const texts = [...drawing.querySelectorAll('text')].filter(each => each.textContent);
  return [
    Math.min(...texts.map(each => parseFloat(getComputedStyle(each).fontSize) * scale)),
    texts.filter(each => {
      const {left, right} = each.getBoundingClientRect();
      return left < frame.left - 1 || right > frame.right + 1;
    }).map(each => each.textContent),
    scene.scrollWidth > scene.clientWidth,
  ];
}'''


@pytest.mark.parametrize('width', [320, 390, 728, 1280, 1920])
def test_no_letter_is_smaller_than_11_px_or_cut_off_and_what_is_made_for_a_phone_does_not_scroll(browser, width):
    page = browser.new_page(viewport={'width': width, 'height': 900})
    page.set_content(svg.STYLE + ''.join(f'<div id="{name}">{picture.html(svg.Animation(is_still=True))}</div>'
                                         for name, picture in PICTURES.items()))
    for name in PICTURES:
        smallest, is_cut, scrolls = page.evaluate(LOOK, name)
        assert smallest >= 11 and not is_cut, name
        assert not (scrolls and (name in NARROW or width > 720)), name
    page.close()


@pytest.mark.parametrize('width', [240, 320, 390, 440, 600, 728, 800, 1280])
def test_no_letter_beside_a_robot_is_smaller_than_11_px(browser, width):
    page = browser.new_page(viewport={'width': width, 'height': 900})
    page.set_content(driving.replay(cart_on_trip('/cart', 1.0, 0.5)))
    assert page.locator('.robot-scene > svg').evaluate('''drawing => Math.min(
        ...[...drawing.querySelectorAll('text')].map(each => parseFloat(getComputedStyle(each).fontSize))
    ) * drawing.getBoundingClientRect().width / drawing.viewBox.baseVal.width''') >= 10.99
    page.close()
