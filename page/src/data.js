// The page's data: one JSON document, and one compressed block of arrays that it points into.
import { gunzipSync } from "fflate";

const KINDS = { f4: Float32Array, u2: Uint16Array, u4: Uint32Array, i1: Int8Array };

/** The data that stands in the page. */
export const load = () =>
  unpack(JSON.parse(document.getElementById("data").textContent), document.getElementById("block").textContent);

/** Unpacks a block, text in base 64, and returns the document with its arrays in place. */
export async function unpack(document_, block) {
  if (document_.format !== "cadgen-report" || document_.version !== 1) throw new Error("unknown data");
  const buffer = await unpacked(bytes(block));
  const filled = (value) => {
    if (Array.isArray(value)) return value.map(filled);
    if (value && typeof value === "object") {
      if ("at" in value && "kind" in value) return new KINDS[value.kind](buffer, value.at, value.n);
      return Object.fromEntries(Object.entries(value).map(([key, inside]) => [key, filled(inside)]));
    }
    return value;
  };
  return filled(document_);
}

/** Bytes of a text in base 64. */
function bytes(text) {
  const letters = atob(text);
  const packed = new Uint8Array(letters.length);
  for (let i = 0; i < packed.length; i++) packed[i] = letters.charCodeAt(i); // a tenth of the time of Uint8Array.from
  return packed;
}

async function unpacked(packed) {
  if (typeof DecompressionStream === "function") {
    return new Response(new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"))).arrayBuffer();
  }
  return gunzipSync(packed).slice().buffer;
}
