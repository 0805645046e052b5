/* Put into Sphinx's search, which rates a page by the best of the words asked for: so that the one with more of them in its
   title comes first. */
// @ts-nocheck: Scorer, splitQuery, stopwords and Stemmer are Sphinx's.

Scorer.score = ([, title, , , score]) => {
  const wordsOf = text => splitQuery(text.toLowerCase()).map(word => new Stemmer().stemWord(word));
  const asked = wordsOf(new URLSearchParams(location.search).get('q') ?? '').filter(word => !stopwords.has(word));
  return score + 10 * wordsOf(title).filter(word => asked.includes(word)).length;
};
