'use strict';

/** What the page's scripts share. */
const page = {
  element: (id) => document.getElementById(id),

  /** Data that the page carries under an id. */
  embedded(id) {
    const block = page.element(id);
    return block ? JSON.parse(block.textContent) : null;
  },

  /** CSV without quoting, as objects by the names of the header. */
  csvRows(text) {
    const [header, ...lines] = text.trimEnd().split('\n').map((line) => line.split(',').map((field) => field.trim()));
    return lines.map((fields) => Object.fromEntries(header.map((name, i) => [name, fields[i]])));
  },

  /** A new element of a drawing, or of the page if the parent is in no drawing. */
  add(parent, name, attributes = {}, text = '') {
    const drawing = parent.namespaceURI === page.drawing || name === 'svg';
    const child = drawing ? document.createElementNS(page.drawing, name) : document.createElement(name);
    for (const [key, value] of Object.entries(attributes)) child.setAttribute(key, value);
    if (text !== '') child.textContent = text;
    return parent.appendChild(child);
  },
  drawing: 'http://www.w3.org/2000/svg',

  clamp: (value, low, high) => Math.min(Math.max(value, low), high),
};

// Buttons that save an embedded CSV as a file.
for (const button of document.querySelectorAll('button[data-csv]')) {
  button.addEventListener('click', () => {
    const link = document.createElement('a');
    link.href = URL.createObjectURL(new Blob([page.embedded(button.dataset.csv)], {type: 'text/csv'}));
    link.download = button.dataset.file;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
  });
}

// A table that is cut says so, as long as it is.
const cuts = new ResizeObserver((entries) => setTimeout(() => {  // later: the hint changes the box's size itself
  for (const {target} of entries) {
    const box = target.closest('.scroll');
    box.classList.toggle('cut', box.scrollWidth > box.clientWidth + 1);
  }
}));
for (const box of document.querySelectorAll('.scroll')) {
  cuts.observe(box);
  cuts.observe(box.querySelector('table'));
}

// Paper has no summary to click on: everything folded is unfolded for printing.
addEventListener('beforeprint', () => {
  for (const details of document.querySelectorAll('details:not([open])')) {
    details.dataset.folded = '';
    details.open = true;
  }
});
addEventListener('afterprint', () => {
  for (const details of document.querySelectorAll('details[data-folded]')) {
    delete details.dataset.folded;
    details.open = false;
  }
});
