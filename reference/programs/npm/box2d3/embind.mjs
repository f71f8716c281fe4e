// Box2D's functions without the handles that Emscripten's embind makes of every struct they return, which take longer
// than a step of the body that is read. A function that is registered with embind is one of the WebAssembly table: it
// takes structs by their addresses, and where it returns one, the address to write it to comes first (the C ABI of
// WebAssembly). Lists of structs are built value by value (emval): `listed` keeps the addresses of these values, which
// are copies, and no handles are made.
export const memory = { words: new Int32Array(), floats: new Float32Array() }; // by refresh: it moves when it grows

const registered = new Map(); // by the address of a function's name: its index in the table
let list = null;
const { instantiate } = WebAssembly;
WebAssembly.instantiate = async (source, imports) => {
  const instead = { // of the imports with these names
    __embind_register_function: (call) => (...args) => (registered.set(args[0], args[5]), call(...args)),
    __emval_new_array: (call) => () => (list ? 0 : call()),
    __emval_invoke: (call) => (caller, object, method, out, values) =>
      list ? memory.words[values >> 2] : call(caller, object, method, out, values),
    __emval_set_property: (call) => (object, key, value) => (list ? list.push(value) : call(object, key, value)),
    __emval_decref: (call) => (handle) => { if (!list) call(handle); },
  };
  const wrapped = (given) => {
    if (given instanceof WebAssembly.Memory) memory.of = given;
    return instead[given.name]?.(given) ?? given;
  };
  for (const part of Object.values(imports)) {
    for (const [key, value] of Object.entries(part)) part[key] = wrapped(value);
  }
  const made = await instantiate(source, imports);
  const exported = Object.values(made.instance.exports);
  memory.of ??= exported.find((it) => it instanceof WebAssembly.Memory);
  memory.table = exported.find((it) => it instanceof WebAssembly.Table);
  return made;
};
const { default: Box2D } = await import('box2d3-wasm');
export const b2 = await Box2D();
WebAssembly.instantiate = instantiate;

const nameAt = (at) => String.fromCharCode(...b2.HEAPU8.slice(at, b2.HEAPU8.indexOf(0, at)));

/** The engine's functions by name. */
export const direct = Object.fromEntries([...registered].map(([name, index]) =>
  [nameAt(name), memory.table.get(index)]));

/** The addresses of the structs in the lists that direct calls of read() return; read gets those so far. Free each. */
export function listed(read) {
  refresh();
  list = [];
  try {
    read(list);
    refresh();
    return list;
  } finally {
    list = null;
  }
}

export function refresh() {
  const { buffer } = memory.of;
  if (memory.words.buffer === buffer) return;
  Object.assign(memory, { words: new Int32Array(buffer), floats: new Float32Array(buffer) });
}
