// SPDX-License-Identifier: GPL-2.0-or-later
// Colours. Classes are told apart by the palette of Okabe and Ito (2008), made for readers who are blind to
// red or green; its eighth colour, black, is that of the edges. Their order is that of the files which
// `tetrarch embed` writes. Lengths of words run from light to dark, so that they can be read in grey.

const CLASSES = ['#e69f00', '#56b4e9', '#009e73', '#f0e442', '#0072b2', '#d55e00', '#cc79a7'];
const LENGTHS = ['#ffe08a', '#f6b26b', '#e0787c', '#b0568f', '#75449a', '#45387f', '#262450'];

/// A field from low to high: five colours of viridis (Smith and van der Walt 2015), of even steps in lightness.
export const SCALE = ['#440154', '#3b528b', '#21918c', '#5ec962', '#fde725'];

export const THEMES = {
  light: {
    background: '#f7f7f4',
    ink: '#1d232b',
    paper: '#fbf7ec',
    line: '#8b8f96',
    ground: '#d9dade',
    planar: '#ffffff',
    rim: '#5b616a',
  },
  dark: {
    background: '#14171c',
    ink: '#f1efe8',
    paper: '#efeadf',
    line: '#7d8590',
    ground: '#2b313b',
    planar: '#1c2027',
    rim: '#14171c',
  },
};

/// "#rrggbb" as three numbers from 0 to 255.
export function rgb(hex) {
  return [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16));
}

export function mix(a, b, amount) {
  return a.map((x, i) => x + (b[i] - x) * amount);
}

/// The colour of class i; the palette's second and third round are lighter and darker.
export function classColour(i) {
  const colour = mix(rgb(CLASSES[i % CLASSES.length]), [255, 255, 255], 0.1);
  const round = Math.floor(i / CLASSES.length) % 3;
  return round === 0
    ? colour
    : mix(colour, round === 1 ? [255, 255, 255] : [0, 0, 0], round === 1 ? 0.5 : 0.42);
}

/// The colour of a word of the given length when the longest has the other one.
export function lengthColour(length, longest) {
  const at = (longest > 0 ? length / longest : 0) * (LENGTHS.length - 1);
  const i = Math.min(Math.floor(at), LENGTHS.length - 2);
  return mix(rgb(LENGTHS[i]), rgb(LENGTHS[i + 1]), at - i);
}

export const css = (colour) => `rgb(${colour.map(Math.round).join(' ')})`;
