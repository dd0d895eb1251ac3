# The program in an image: docs/src/guide/install.md says how it is built and used.

ARG RUST=1.95.0
FROM rust:${RUST}-bookworm AS build
ARG RUST
# The toolchain of the image: without this rustup fetches the one that rust-toolchain.toml names.
ENV RUSTUP_TOOLCHAIN=${RUST}
WORKDIR /lanchester
COPY . .
RUN cargo build --release --locked --package lanchester-cli --package lanchester-fmu --bins --lib

FROM debian:bookworm-slim
RUN useradd --uid 1000 --create-home engineer && install --directory --owner=engineer /engines
COPY --from=build /lanchester/target/release/lanchester /usr/bin/
# Where `export fmu` looks for the binary of units.
COPY --from=build /lanchester/target/release/liblanchester_fmu.so /usr/lib/lanchester/
COPY --from=build /lanchester/LICENSE-APACHE /lanchester/LICENSE-MIT /lanchester/crates/studio/third-party.txt /usr/share/doc/lanchester/
USER engineer
WORKDIR /engines
# The studio's: lanchester studio --all-interfaces --port 7070 --no-open
EXPOSE 7070
ENTRYPOINT ["lanchester"]
CMD ["--help"]
