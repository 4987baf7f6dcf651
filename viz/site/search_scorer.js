/* The scores of Sphinx's search, and above them what a query names: "sky view factor" finds `sky_view_factor` first. */
var Scorer = {
  objNameMatch: 11,
  objPartialMatch: 6,
  objPrio: { 0: 15, 1: 5, 2: -5 },
  objPrioDefault: 0,
  title: 15,
  partialTitle: 7,
  term: 5,
  partialTerm: 2,

  score: ([, title, , , score, , kind]) => {
    const asked = new URLSearchParams(window.location.search).get("q") ?? "";
    const parts = title.toLowerCase().split(".");
    const name = asked.trim().toLowerCase().replace(/[\s-]+/g, "_");
    const named = kind === "object" && (parts.at(-1) === name || parts.join(".") === name);
    return named ? score + 200 - parts.length : score; // of names that end alike the shortest
  },
};
