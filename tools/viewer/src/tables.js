// SPDX-License-Identifier: GPL-2.0-or-later
// The tables: each a piece of the page that can be folded away.

/// Longer tables are folded at first.
const LONGEST_OPEN = 12;

/// Numbers in columns are set flush right, so that their digits stand below each other.
const isNumber = (text) => /^[-+]?[\d.]+(e[-+]?\d+)?$/i.test(text);

function row(cells, tag, firstIsHeading, aligned) {
  const line = document.createElement('tr');
  cells.forEach((text, i) => {
    const cell = document.createElement(firstIsHeading && i === 0 ? 'th' : tag);
    if (cell.tagName === 'TH') cell.scope = tag === 'th' ? 'col' : 'row';
    cell.textContent = text;
    if (aligned && isNumber(text)) cell.className = 'number';
    line.append(cell);
  });
  return line;
}

function tableOf({ rows, columns }) {
  const table = document.createElement('table');
  const body = table.createTBody();
  body.append(...rows.map((cells) => row(cells, 'td', true, Boolean(columns))));
  if (columns) {
    const head = row(columns, 'th', false, false);
    // A column's heading stands where its entries do.
    Array.from(head.cells).forEach((cell, i) =>
      cell.classList.toggle('number', rows.length > 0 && rows.every((cells) => isNumber(cells[i] ?? ''))),
    );
    table.createTHead().append(head);
  }
  return table;
}

export function showTables(tables, place) {
  for (const data of tables) {
    const details = document.createElement('details');
    details.open = data.rows.length <= LONGEST_OPEN;
    const summary = document.createElement('summary');
    summary.textContent = data.heading;
    const scroller = document.createElement('div');
    scroller.className = 'scroller';
    const table = tableOf(data);
    table.setAttribute('aria-label', data.heading);
    scroller.append(table);
    details.append(summary, scroller);
    place.append(details);
  }
}
