//! Steps one after another or beside one another, each with its time; the first failure stops them.

use anyhow::{Context, Result};
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

type Work<'a> = Box<dyn FnOnce() -> Result<String> + Send + 'a>;

/// Steps that run one after another, beside those of other lanes.
#[derive(Default)]
pub struct Lane<'a> {
    steps: Vec<(&'static str, Work<'a>)>,
}

impl<'a> Lane<'a> {
    /// One without steps.
    pub fn new() -> Lane<'a> {
        Lane::default()
    }

    /// One step more; what it returns is a remark for the list, what it fails with is its output.
    pub fn step(mut self, name: &'static str, work: impl FnOnce() -> Result<String> + Send + 'a) -> Lane<'a> {
        self.steps.push((name, Box::new(work)));
        self
    }
}

/// Steps that are done.
#[derive(Default)]
pub struct Steps {
    done: Vec<Done>,
    /// From the first step to the last.
    time: Duration,
}

/// A step that is done: its name, its time, its remark.
type Done = (&'static str, Duration, String);

impl Steps {
    /// Runs one step.
    pub fn run<'a>(
        &mut self,
        name: &'static str,
        work: impl FnOnce() -> Result<String> + Send + 'a,
    ) -> Result<()> {
        self.beside(vec![Lane::new().step(name, work)])
    }

    /// Runs lanes beside one another; after a failure no further step begins.
    pub fn beside(&mut self, lanes: Vec<Lane>) -> Result<()> {
        let start = Instant::now();
        let (done, failed) = (Mutex::new(Vec::new()), AtomicBool::new(false));
        let results: Vec<Result<()>> = std::thread::scope(|scope| {
            let threads: Vec<_> = lanes
                .into_iter()
                .map(|lane| {
                    let (done, failed) = (&done, &failed);
                    scope.spawn(move || -> Result<()> {
                        for (name, work) in lane.steps {
                            if failed.load(Ordering::Relaxed) {
                                break;
                            }
                            let result = one(name, work);
                            failed.fetch_or(result.is_err(), Ordering::Relaxed);
                            done.lock().unwrap_or_else(|poisoned| poisoned.into_inner()).push(result?);
                        }
                        Ok(())
                    })
                })
                .collect();
            threads
                .into_iter()
                .map(|thread| thread.join().unwrap_or_else(|_| Err(anyhow::anyhow!("a step panicked"))))
                .collect()
        });
        self.time += start.elapsed();
        self.done.extend(done.into_inner().unwrap_or_else(|poisoned| poisoned.into_inner()));
        results.into_iter().collect()
    }

    /// The list of all.
    pub fn print(&self) {
        println!("\nall steps passed");
        for (name, time, remark) in &self.done {
            println!("{:8.1} s  {name:50} {remark}", time.as_secs_f64());
        }
        println!(
            "{:8.1} s  in all, where steps beside one another share the processors",
            self.time.as_secs_f64()
        );
    }
}

fn one(name: &'static str, work: Work) -> Result<Done> {
    println!("== {name}");
    let start = Instant::now();
    let remark = work().with_context(|| format!("step failed: {name}"))?;
    let time = start.elapsed();
    println!("   {:.1} s  {name}: {}", time.as_secs_f64(), if remark.is_empty() { "done" } else { &remark });
    Ok((name, time, remark))
}

#[cfg(test)]
mod tests {
    use super::*;
    use anyhow::bail;
    use std::sync::mpsc::channel;

    #[test]
    fn lanes_run_beside_one_another_and_their_steps_in_order() {
        let (to_right, from_left) = channel();
        let (to_left, from_right) = channel();
        let mut steps = Steps::default();
        // Each lane waits for the other's first step.
        let left = Lane::new()
            .step("left", move || Ok(to_right.send(()).map(|()| String::new())?))
            .step("left again", move || Ok(from_right.recv().map(|()| "heard".to_owned())?));
        let right = Lane::new()
            .step("right", move || Ok(to_left.send(()).map(|()| String::new())?))
            .step("right again", move || Ok(from_left.recv().map(|()| "heard".to_owned())?));
        steps.beside(vec![left, right]).expect("both lanes pass");
        let heard = steps.done.iter().filter(|(_, _, remark)| remark == "heard").count();
        assert_eq!((steps.done.len(), heard), (4, 2));
    }

    #[test]
    fn a_failure_stops_its_lane_and_is_told_with_its_step() {
        let mut steps = Steps::default();
        let lane = Lane::new()
            .step("first", || bail!("broken"))
            .step("second", || panic!("it must not run after a failure"));
        let error = steps.beside(vec![lane]).expect_err("the first step fails");
        assert_eq!(format!("{error:#}"), "step failed: first: broken");
        assert!(steps.done.is_empty());
    }
}
