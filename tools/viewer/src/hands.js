// SPDX-License-Identifier: GPL-2.0-or-later
// What mouse, fingers and wheel do over an element.

/// How much nearer one comes by a hundredth of a notch of the wheel, and by a pixel with the middle button.
const WHEEL = 0.95;
const DRAG = 0.99;
/// Pixels in a line and in a page, as wheels may count.
const WHEEL_UNITS = [1, 16, 100];
/// Browsers report a pinch on a touchpad as a wheel with the control key, in small steps.
const PINCH = 10;

/// What a pointer that goes down is going to do.
function purpose({ pointerType, button, ctrlKey, metaKey, shiftKey }) {
  if (pointerType === 'touch') return 'turn';
  if (button === 1) return 'zoom';
  return button === 2 || ctrlKey || metaKey || shiftKey ? 'move' : 'turn';
}

/// The middle of the pointers, and how far they are apart.
function summary(pointers) {
  const places = [...pointers.values()].map(({ place }) => place);
  const mean = (i) => places.reduce((sum, place) => sum + place[i], 0) / places.length;
  const [a, b = a] = places;
  return { middle: [mean(0), mean(1)], spread: Math.hypot(a[0] - b[0], a[1] - b[1]) };
}

/// A place of the page as one of the element, from (-1, -1), lower left, to (1, 1).
function placeOn(element, [x, y]) {
  const { left, top, width, height } = element.getBoundingClientRect();
  return [(2 * (x - left)) / width - 1, 1 - (2 * (y - top)) / height];
}

/// Calls `begin()`, then `turn(dx, dy)`, `move(dx, dy)` in pixels to the right and down, or `zoom(factor, at)`
/// about a place of the element, as often as wanted, then `end()`.
export function follow(element, { begin, turn, move, zoom, end }) {
  const pointers = new Map();
  element.style.touchAction = 'none';
  element.addEventListener('contextmenu', (event) => event.preventDefault());

  element.addEventListener('pointerdown', (event) => {
    if (pointers.size === 0) begin();
    element.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, { place: [event.clientX, event.clientY], does: purpose(event) });
  });

  element.addEventListener('pointermove', (event) => {
    const pointer = pointers.get(event.pointerId);
    if (!pointer) return;
    const before = summary(pointers);
    pointer.place = [event.clientX, event.clientY];
    const { middle, spread } = summary(pointers);
    const [dx, dy] = middle.map((x, i) => x - before.middle[i]);
    if (pointers.size > 1) {
      move(dx, dy);
      if (before.spread > 0 && spread > 0) zoom(spread / before.spread, placeOn(element, middle));
    } else if (pointer.does === 'zoom') zoom(DRAG ** dy);
    else (pointer.does === 'move' ? move : turn)(dx, dy);
  });

  const released = (event) => {
    if (pointers.delete(event.pointerId) && pointers.size === 0) end();
  };
  element.addEventListener('pointerup', released);
  element.addEventListener('pointercancel', released);

  const turned = (event) => {
    event.preventDefault();
    const pixels = event.deltaY * WHEEL_UNITS[event.deltaMode] * (event.ctrlKey ? PINCH : 1);
    begin();
    zoom(WHEEL ** (pixels / 100), placeOn(element, [event.clientX, event.clientY]));
    end();
  };
  element.addEventListener('wheel', turned, { passive: false });
}
