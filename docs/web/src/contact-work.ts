// <contact-work>: a reader's own work, on one page.

export class ContactWork extends HTMLElement {}

customElements.define("contact-work", ContactWork);
