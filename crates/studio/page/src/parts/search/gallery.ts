// By which names engines of the gallery are looked for, besides their titles.

const NUMBERS = [
  ["one", "single"],
  ["two", "twin"],
  ["three", "triple"],
  ["four"],
  ["five"],
  ["six"],
  ["seven"],
  ["eight"],
  ["nine"],
  ["ten"],
  ["eleven"],
  ["twelve"],
  ["thirteen"],
  ["fourteen"],
  ["fifteen"],
  ["sixteen"],
];
const MOTORCYCLE = "motorcycle motorbike bike";
const AIRCRAFT = "aircraft aeroplane airplane aero plane";
const CAR = "car automobile";
const SHIP = "ship marine locomotive";

/** Where a layout is used, and who is known for it. */
const KNOWN: Record<string, string> = {
  single: `${MOTORCYCLE} thumper lawn mower generator`,
  "single-two-shafts": `${MOTORCYCLE} thumper`,
  "twin-360": `${MOTORCYCLE} British Triumph Bonneville BSA Norton`,
  "twin-180": `${MOTORCYCLE} Honda Kawasaki`,
  "twin-270": `${MOTORCYCLE} Yamaha MT-07 Honda Africa Twin Triumph`,
  "boxer-2": `${MOTORCYCLE} BMW Citroen ${AIRCRAFT}`,
  "v2-45": `${MOTORCYCLE} Harley-Davidson Harley cruiser`,
  "v2-60-split": MOTORCYCLE,
  "v2-90": `${MOTORCYCLE} Ducati L-twin Moto Guzzi`,
  "in-line-2-two-stroke": `${MOTORCYCLE} snowmobile outboard ${AIRCRAFT} Rotax`,
  "in-line-3": `${CAR} ${MOTORCYCLE} diesel Triumph`,
  "in-line-3-shaft": `${CAR} diesel`,
  "in-line-3-two-stroke": `${CAR} ${MOTORCYCLE} outboard DKW Saab Kawasaki`,
  "in-line-4": `${CAR} ${MOTORCYCLE} truck diesel petrol`,
  "in-line-4-lanchester": `${CAR} diesel balance shafts Mitsubishi silent shaft Porsche 944`,
  "in-line-4-crossplane": `${MOTORCYCLE} Yamaha R1`,
  "in-line-5": `${CAR} diesel Audi Volvo Mercedes`,
  "in-line-6": `${CAR} truck lorry diesel ${SHIP} BMW Jaguar`,
  "in-line-8": `${CAR} Bugatti Duesenberg Alfa Romeo`,
  "boxer-4": `${CAR} Subaru Volkswagen Beetle VW Porsche ${AIRCRAFT} Lycoming Continental`,
  "boxer-6": `${CAR} Porsche 911 Subaru ${MOTORCYCLE} Honda Gold Wing ${AIRCRAFT} Lycoming Continental`,
  "flat-12": `${CAR} racing Ferrari Porsche 917`,
  "v4-90": `${MOTORCYCLE} Honda VFR`,
  "v6-60": `${CAR} Ford Nissan Alfa Romeo`,
  "v6-90": `${CAR} Audi Mercedes Buick`,
  "v6-90-odd": `${CAR} Buick PRV Peugeot Renault Volvo`,
  "v6-120": `${CAR} racing Ferrari McLaren`,
  "vr6-15": `${CAR} Volkswagen VW`,
  "v8-crossplane": `${CAR} truck diesel American Chevrolet Ford Mercedes`,
  "v8-flat-plane": `${CAR} racing Ferrari Cosworth Corvette`,
  "v10-72": `${CAR} Lexus LFA`,
  "v10-90": `${CAR} Dodge Viper BMW M5`,
  "v12-60": `${CAR} Ferrari Lamborghini Jaguar BMW diesel ${SHIP} ${AIRCRAFT} Rolls-Royce Merlin`,
  "v16-45": `${CAR} Cadillac diesel ${SHIP}`,
  "w12-broad-arrow": `${AIRCRAFT} Napier Lion`,
  "radial-9": "Wright Pratt Whitney Wasp Bristol",
  "radial-14": "Wright Pratt Whitney Twin Wasp double row",
  "square-4": `${MOTORCYCLE} Ariel Suzuki two crankshafts`,
  "opposed-piston-3": `diesel Junkers Fairbanks Morse truck ${SHIP} ${AIRCRAFT} two crankshafts`,
};

/** What engines of a kind are called, by their number of cylinders. */
const KINDS: [RegExp, (count: number) => string][] = [
  [/^single/, () => "inline in-line straight I1 one-cylinder one cylinder"],
  [/^twin-/, () => "inline in-line straight parallel I2 L2 P2 two cylinders"],
  [/^in-line-(\d+)/, (count) => `inline straight row I${count} L${count}`],
  [/^boxer-(\d+)/, (count) => `flat boxer horizontally opposed pancake F${count} H${count} B${count}`],
  [/^flat-(\d+)/, (count) => `flat boxer F${count} V${count}`],
  [/^vr(\d+)/, (count) => `VR vee V${count} narrow angle`],
  [/^v(\d+)/, (count) => `vee V${count} V-${count}${count === 2 ? " V-twin" : ""}`],
  [/^w(\d+)/, (count) => `W${count} W-${count}`],
  [/^radial-(\d+)/, () => `${AIRCRAFT} star`],
];

/** Other names of an engine of the gallery, by its short name. */
export function usualNames(name: string): string {
  const kind = KINDS.flatMap(([sign, words]) => {
    const match = sign.exec(name);
    if (!match) return [];
    const count = Number(match[1] ?? 0);
    return [
      words(count),
      ...(count > 0 ? [...(NUMBERS[count - 1] ?? []), "cylinders", `${count}-cylinder`] : []),
    ];
  });
  return [...kind, KNOWN[name] ?? ""].join(" ").trim();
}
