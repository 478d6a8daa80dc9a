// Requests to the server that the page came from; addresses are relative, and so carry the token.

/** A refusal: a sentence in both languages, and the status if the server has answered. */
class Refusal extends Error {
  constructor(said, status, floor) {
    super(said[0]);
    Object.assign(this, { said, status, floor });
  }
}

/** Asks for something; with a body it is sent. */
export async function ask(path, body) {
  const options = body === undefined ? {} : { method: "POST", headers: { "Content-Type": "application/json" }, body: JSON.stringify(body) };
  let response;
  let answer;
  try {
    response = await fetch(path, options);
    answer = await response.json();
  } catch (error) {
    throw new Refusal([String(error), String(error)], undefined);
  }
  if (!response.ok) throw new Refusal([answer.error, answer.zh], response.status, answer.floor);
  return answer;
}

const PATIENCE = 1; // s: a browser has six connections to a server, and one that waits for a result would keep a change waiting

/** Asks for a result again and again until it is there. */
export async function askForResult(stage, revision) {
  for (;;) {
    const answer = await ask(`result?stage=${stage}&revision=${revision}&patience=${PATIENCE}`);
    if (answer.document) return answer;
  }
}
