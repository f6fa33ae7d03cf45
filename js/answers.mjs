// What a thread answers to a question of worker.mjs. A copy of an error or of a verdict would not
// be one: their facts are sent.
export const answers = (oracle, say) => ({ number, question, words }) => {
  try {
    const answer = oracle[question](...words);
    if (answer instanceof oracle.Verdict) say({ number, kind: 'Verdict', answer: { ...answer } });
    else say({ number, answer });
  } catch ({ name, message }) {
    say({ number, fault: { name, message } });
  }
};
