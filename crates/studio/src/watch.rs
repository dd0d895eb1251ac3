//! Tells the page when the open file changes on the disk.

use crate::asking::Desk;
use axum::response::sse::{Event, KeepAlive, KeepAliveStream, Sse};
use lanchester_answers::FileState;
use std::convert::Infallible;
use std::sync::Arc;
use std::time::Duration;
use tokio_stream::wrappers::ReceiverStream;

/// How often the file is looked at.
const PERIOD: Duration = Duration::from_millis(700);
/// How long a change must stand before it is told: programs that write in place empty the file first.
const SETTLED: Duration = Duration::from_millis(60);

/// Events `file`, each with the file as it stands or `null`: once at the start, then with every change.
pub(crate) fn events(desk: Arc<Desk>) -> Sse<KeepAliveStream<ReceiverStream<Result<Event, Infallible>>>> {
    let (sender, receiver) = tokio::sync::mpsc::channel(4);
    tokio::spawn(async move {
        let mut told = None;
        let key = |state: &Option<FileState>| {
            state.as_ref().map(|state| (state.name.clone(), state.revision.clone()))
        };
        let look = || {
            let desk = desk.clone();
            async move { tokio::task::spawn_blocking(move || desk.studio.open_file()).await.ok().flatten() }
        };
        loop {
            let state = look().await;
            if told.as_ref() != Some(&key(&state)) {
                tokio::time::sleep(SETTLED).await;
                if key(&look().await) != key(&state) {
                    continue;
                }
                told = Some(key(&state));
                let Ok(event) = Event::default().event("file").json_data(&state) else { break };
                if sender.send(Ok(event)).await.is_err() {
                    break;
                }
            } else if sender.is_closed() {
                break;
            }
            tokio::time::sleep(PERIOD).await;
        }
    });
    Sse::new(ReceiverStream::new(receiver)).keep_alive(KeepAlive::default())
}
