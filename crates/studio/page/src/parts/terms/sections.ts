// Sections of the book, in a file of their own: it is loaded when the first one is read.

export { default } from "virtual:book";
