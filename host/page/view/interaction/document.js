// Elements of the page are found by their ids, and show tables and messages.

/**
 * Element of this id.
 * @type {(id: string) => any}
 */
const element = (id) => document.getElementById(id);

/**
 * Elements of a selector.
 * @type {(selector: string) => any[]}
 */
const elements = (selector) => [...document.querySelectorAll(selector)];

/** Shows a message on a topic; an empty text removes the message if it is on that topic. */
function showMessage(topic, text, isError = true) {
  const message = element("message");
  if (!text && message.dataset.topic !== topic) return;
  message.dataset.topic = topic;
  message.textContent = text;
  message.hidden = !text;
  message.classList.toggle("error", isError);
}

/** Marks a field as wrong or right. */
function mark(field, wrong) {
  if (wrong) field.setAttribute("aria-invalid", "true");
  else field.removeAttribute("aria-invalid");
}

/** Fills a table. Existing rows are kept, so that a tooltip stays open. */
function fillTable(table, facts, scenario) {
  while (table.rows.length > facts.length) table.deleteRow(-1);
  facts.forEach(([name, value, si, definition], i) => {
    const row = table.rows[i] ?? newRow(table);
    const [label, cell] = row.children;
    const [term] = label.children;
    if (term.textContent !== name) term.textContent = name;
    if (term.dataset.define !== definition) {
      term.dataset.define = definition;
      term.setAttribute("aria-description", definition);
    }
    const unit = unitName(si, scenario);
    const text = value === "–" ? value : `${value}${unit && unit !== "°" ? " " : ""}${unit}`;
    if (cell.textContent !== text) cell.textContent = text;
  });
}

function newRow(table) {
  const row = table.insertRow();
  row.innerHTML = '<th scope="row"><span class="term" tabindex="0"></span></th><td></td>';
  return row;
}
