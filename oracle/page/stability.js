'use strict';

// The cell of a stability map that is pointed at or tapped, in words below the maps.
(() => {
  const maps = page.element('stability-maps');
  if (!maps) return;
  const readout = page.element('stability-readout');
  const show = (event) => {
    const cell = event.target.closest('td[title]');
    if (!cell) return;
    const table = cell.closest('table');
    const problem = cell.parentElement.cells[0].textContent;
    const law = table.tHead.rows[0].cells[cell.cellIndex].textContent;
    const integrator = table.caption.textContent;
    readout.textContent = `${problem}, ${law}, ${integrator}: ${cell.title}.`;
  };
  maps.addEventListener('pointerover', show);
  maps.addEventListener('click', show);
})();
