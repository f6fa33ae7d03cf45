// Elements of the page. Texts are nodes and attributes are set, so that no name is ever read as
// markup.
function filled(node, attributes, children) {
  for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, value);
  node.append(...children.filter((child) => child !== undefined && child !== null));
  return node;
}

export const element = (tag, attributes = {}, ...children) =>
  filled(document.createElement(tag), attributes, children);

export const svg = (tag, attributes = {}, ...children) =>
  filled(document.createElementNS('http://www.w3.org/2000/svg', tag), attributes, children);

// A button; if `act` returns whether something is on, the button says so.
export function button(words, act, pressed) {
  const node = element('button', { type: 'button' }, words);
  if (pressed !== undefined) node.setAttribute('aria-pressed', pressed);
  node.addEventListener('click', () => {
    const on = act(node);
    if (pressed !== undefined) node.setAttribute('aria-pressed', Boolean(on));
  });
  return node;
}

export function slider(words, min, max, value, act) {
  const input = element('input', { type: 'range', min, max, step: (max - min) / 100, value });
  input.addEventListener('input', () => act(Number(input.value)));
  return element('label', {}, words, ' ', input);
}

// `about`: what the table belongs to, for those who cannot see where it stands.
export function table(about, caption, heads, rows) {
  return element('div', { class: 'wide', tabindex: '0', role: 'region', 'aria-label': `${about}: ${caption}` },
    element('table', {}, element('caption', {}, caption),
      element('thead', {}, element('tr', {}, ...heads.map((head) => element('th', { scope: 'col' }, head)))),
      element('tbody', {}, ...rows.map((row) => element('tr', {}, ...row.map((cell, i) =>
        i === 0 ? element('th', { scope: 'row' }, cell) : element('td', {}, cell)))))));
}
