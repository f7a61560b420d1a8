//! A thread that owns a GPU: whoever asks waits no longer than a limit, whatever the driver does.

use std::sync::mpsc::{self, RecvTimeoutError};
use std::sync::{Mutex, MutexGuard};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

use crate::error::{Error, Result};

type Job<T> = Box<dyn FnOnce(&T) + Send>;

/// A thread that owns a `T`. One that does not answer in time is given up, and every later call is refused.
#[derive(Debug)]
pub struct OwningThread<T> {
    /// `None` once the thread was given up or is being joined.
    jobs: Mutex<Option<mpsc::Sender<Job<T>>>>,
    thread: Option<JoinHandle<()>>,
    /// Time that callers may still spend waiting.
    left: Mutex<Duration>,
}

impl<T: Send + 'static> OwningThread<T> {
    /// Starts the thread; calls are refused before [`Self::allow`].
    pub fn new(owned: T) -> Self {
        let (sender, receiver) = mpsc::channel::<Job<T>>();
        let thread = std::thread::spawn(move || receiver.into_iter().for_each(|job| job(&owned)));
        Self { jobs: Mutex::new(Some(sender)), thread: Some(thread), left: Mutex::new(Duration::ZERO) }
    }

    /// Allows so much waiting from now on, over all calls together.
    pub fn allow(&self, time: Duration) {
        *locked(&self.left) = time;
    }

    /// Runs `work` on the thread and waits for it.
    ///
    /// # Errors
    /// Those of `work`; `Error::Gpu` when the allowed time is used up, if `work` panicked, or if either happened before.
    pub fn run<R: Send + 'static>(
        &self,
        doing: &str,
        work: impl FnOnce(&T) -> Result<R> + Send + 'static,
    ) -> Result<R> {
        let (sender, receiver) = mpsc::channel();
        let job: Job<T> = Box::new(move |owned| {
            // Nobody listens any more after the time limit.
            sender.send(work(owned)).ok();
        });
        let sent = locked(&self.jobs).as_ref().map(|jobs| jobs.send(job));
        let Some(Ok(())) = sent else {
            return Err(Error::Gpu(format!("cannot {doing}: it was given up after it had not answered in time")));
        };
        let (started, allowed) = (Instant::now(), *locked(&self.left));
        let outcome = receiver.recv_timeout(allowed);
        self.allow(allowed.saturating_sub(started.elapsed()));
        outcome.unwrap_or_else(|failure| {
            locked(&self.jobs).take();
            Err(Error::Gpu(match failure {
                RecvTimeoutError::Timeout => format!(
                    "cannot {doing}: no answer in the time allowed; the driver hangs or is too slow, set gpu.check = \
                     \"off\" to go on"
                ),
                RecvTimeoutError::Disconnected => format!("cannot {doing}: the driver's interface broke down"),
            }))
        })
    }
}

impl<T> Drop for OwningThread<T> {
    fn drop(&mut self) {
        // What the thread owns is dropped with it; a thread that was given up would never end.
        let alive = locked(&self.jobs).take().is_some();
        if let Some(thread) = self.thread.take()
            && alive
        {
            thread.join().ok();
        }
    }
}

fn locked<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(|poisoned| poisoned.into_inner())
}

#[cfg(test)]
mod tests {
    use super::*;

    const SHORT: Duration = Duration::from_millis(50);
    const LONG: Duration = Duration::from_secs(60);

    #[test]
    fn work_is_done_and_its_errors_come_back() {
        let thread = OwningThread::new(3);
        thread.allow(LONG);
        assert_eq!(thread.run("add", |x| Ok(x + 4)).unwrap(), 7);
        let failed = thread.run("fail", |_| Err::<(), _>(Error::Gpu("lost".into())));
        assert_eq!(failed.unwrap_err().to_string(), Error::Gpu("lost".into()).to_string());
        assert_eq!(thread.run("add", |x| Ok(x + 5)).unwrap(), 8);
    }

    #[test]
    fn a_hang_ends_at_the_limit_and_nothing_is_asked_again() {
        let thread = OwningThread::new(());
        thread.allow(SHORT);
        let started = Instant::now();
        let error = thread.run("draw", |()| {
            std::thread::sleep(LONG);
            Ok(())
        });
        assert!(error.unwrap_err().to_string().contains("cannot draw: no answer"));
        thread.allow(LONG);
        assert!(thread.run("draw again", |()| Ok(())).unwrap_err().to_string().contains("given up"));
        // Neither the calls nor dropping wait for the thread.
        drop(thread);
        assert!(started.elapsed() < LONG / 2);
    }

    #[test]
    fn waiting_adds_up() {
        let thread = OwningThread::new(());
        thread.allow(Duration::from_millis(400));
        let nap = |()| {
            std::thread::sleep(Duration::from_millis(150));
            Ok(())
        };
        let done = (0..4).map(|_| thread.run("nap", move |&()| nap(()))).filter(Result::is_ok).count();
        assert!((1..4).contains(&done), "{done} of 4 naps of 150 ms in 400 ms");
    }

    #[test]
    fn a_panic_is_an_error() {
        let thread = OwningThread::new(());
        thread.allow(LONG);
        let error = thread.run::<()>("draw", |()| panic!("on purpose")).unwrap_err().to_string();
        assert!(error.contains("broke down"), "{error}");
    }
}
