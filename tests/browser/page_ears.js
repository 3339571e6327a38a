"use strict";
// Every complaint of the page, from its first script on.
const complaints = [];
addEventListener("error", (event) => complaints.push(`error: ${event.message ?? event.target}`), true);
addEventListener("unhandledrejection", (event) => complaints.push(`rejection: ${event.reason}`));
for (const level of ["error", "warn"]) {
  console[level] = (...words) => complaints.push(`console.${level}: ${words.join(" ")}`);
}
